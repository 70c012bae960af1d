#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <GL/osmesa.h>

#include "base/error.h"
#include "ui/hosts/memory_context.h"

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
    OsmesaOpenGlContext(Viewport size, int depth_bits) : size_(size) {
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
        pixels_.resize(static_cast<std::size_t>(size.width) *
                       static_cast<std::size_t>(size.height));
        context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
        if (context_ == nullptr) throw AccessError("OSMesa cannot be started.");
    }
    ~OsmesaOpenGlContext() override { OSMesaDestroyContext(context_); }
    OsmesaOpenGlContext(const OsmesaOpenGlContext&) = delete;
    OsmesaOpenGlContext& operator=(const OsmesaOpenGlContext&) = delete;

    void enter() override {
        previous_ = CurrentContext();
        if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size_.width,
                              size_.height) != GL_TRUE)
            throw AccessError("OSMesa cannot be started.");
    }
    void leave() override { previous_.make_current(); }

  private:
    Viewport size_;
    std::vector<std::uint32_t> pixels_;
    OSMesaContext context_ = nullptr;
    CurrentContext previous_;
};

} // namespace

std::unique_ptr<OpenGlContext> make_memory_context(Viewport size, int depth_bits) {
    return std::make_unique<OsmesaOpenGlContext>(size, depth_bits);
}

std::unique_ptr<OpenGlContext> make_opengl_context() {
    return make_memory_context({1, 1}, 0); // it draws to a framebuffer object of its own
}

} // namespace rasterwalk
