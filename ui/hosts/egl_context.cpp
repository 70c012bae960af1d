#include <array>
#include <cstdlib>

#define EGL_NO_X11 // its header would define None, Success and the like
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include "base/error.h"
#include "ui/hosts/memory_context.h"

namespace rasterwalk {

namespace {

/// EGL without screens and devices, never closed: contexts come and go.
EGLDisplay memory_display() {
    static EGLDisplay display = [] {
        // A graphics card would draw other pictures, and other ones on each machine.
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        EGLDisplay opened =
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        return eglInitialize(opened, nullptr, nullptr) == EGL_TRUE ? opened : EGL_NO_DISPLAY;
    }();
    if (display == EGL_NO_DISPLAY)
        throw AccessError("EGL cannot be started without a screen: that needs Mesa's.");
    return display;
}

EGLContext new_context() {
    constexpr std::array attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0,
                                    EGL_NONE};
    EGLDisplay display = memory_display();
    eglBindAPI(EGL_OPENGL_API);
    EGLContext context =
        eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT) throw AccessError("EGL has no OpenGL 3.0 here.");
    return context;
}

bool make_current(EGLContext context) {
    return eglMakeCurrent(memory_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

class EglOpenGlContext final : public OpenGlContext {
  public:
    EglOpenGlContext(Viewport size, int depth_bits) : size_(size), depth_bits_(depth_bits) {}
    ~EglOpenGlContext() override {
        if (eglGetCurrentContext() == context_) make_current(EGL_NO_CONTEXT);
        eglDestroyContext(memory_display(), context_); // and what was made in it
    }
    EglOpenGlContext(const EglOpenGlContext&) = delete;
    EglOpenGlContext& operator=(const EglOpenGlContext&) = delete;

    void enter() override {
        previous_ = eglGetCurrentContext();
        if (!make_current(context_)) throw AccessError("EGL cannot draw without a screen here.");
        if (!has_memory_) make_memory();
        has_memory_ = true;
    }
    void leave() override { make_current(previous_); }

  private:
    /// A framebuffer object takes the place of the surface. It stays bound.
    void make_memory() const {
        GLuint framebuffer = 0;
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
        if (depth_bits_ > 0) attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw AccessError("OpenGL has no memory for a picture of this size.");
        glViewport(0, 0, size_.width, size_.height);
    }
    void attach(GLenum place, GLenum format) const {
        GLuint buffer = 0;
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, size_.width, size_.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    Viewport size_;
    int depth_bits_;
    bool has_memory_ = false;
    EGLContext context_ = new_context();
    EGLContext previous_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<OpenGlContext> make_memory_context(Viewport size, int depth_bits) {
    return std::make_unique<EglOpenGlContext>(size, depth_bits);
}

std::unique_ptr<OpenGlContext> make_opengl_context() {
    return make_memory_context({1, 1}, 0); // it draws to a framebuffer object of its own
}

} // namespace rasterwalk
