#include "ui/hosts/osmesa_context.h"

#include <array>
#include <cstddef>

#include "base/error.h"
#include "ui/hosts/opengl_context.h"

namespace rasterwalk {

namespace {

/// The context that is current, to make it current again.
struct CurrentContext {
    OSMesaContext context = OSMesaGetCurrentContext();
    GLint width = 0, height = 0, format = 0;
    void* pixels = nullptr;

    CurrentContext() {
        if (context != nullptr) OSMesaGetColorBuffer(context, &width, &height, &format, &pixels);
    }
    void make_current() const {
        OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height);
    }
};

class OsmesaOpenGlContext final : public OpenGlContext {
  public:
    void enter() override {
        previous_ = CurrentContext();
        own_.make_current();
    }
    void leave() override { previous_.make_current(); }

  private:
    /// What is drawn goes to a framebuffer object: OSMesa's own memory is not used.
    OsmesaContext own_{{1, 1}, 0};
    CurrentContext previous_;
};

} // namespace

OsmesaContext::OsmesaContext(Viewport size, int depth_bits) : size_(size) {
    const std::array attributes{OSMESA_FORMAT,
                                OSMESA_BGRA,
                                OSMESA_DEPTH_BITS,
                                depth_bits,
                                OSMESA_STENCIL_BITS,
                                0,
                                OSMESA_PROFILE,
                                OSMESA_COMPAT_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION,
                                3,
                                OSMESA_CONTEXT_MINOR_VERSION,
                                0,
                                0};
    pixels_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (context_ == nullptr) throw AccessError("OSMesa cannot be started.");
}

OsmesaContext::~OsmesaContext() {
    OSMesaDestroyContext(context_);
}

void OsmesaContext::make_current() {
    if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.width, size_.height) !=
        GL_TRUE)
        throw AccessError("OSMesa cannot be started.");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
}

std::unique_ptr<OpenGlContext> make_opengl_context() {
    return std::make_unique<OsmesaOpenGlContext>();
}

} // namespace rasterwalk
