#include <GLFW/glfw3.h>

#include "base/error.h"
#include "ui/hosts/opengl_context.h"

namespace rasterwalk {

namespace {

/// A window that is never shown; null if there is no OpenGL 3.0. What is drawn goes to a
/// framebuffer object: the window's own memory is not used.
GLFWwindow* hidden_window() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    return glfwCreateWindow(1, 1, "Rasterwalk OpenGL", nullptr, nullptr);
}

class GlfwOpenGlContext final : public OpenGlContext {
  public:
    GlfwOpenGlContext() {
        if (window_ == nullptr) throw AccessError("this system has no OpenGL 3.0.");
    }
    ~GlfwOpenGlContext() override { glfwDestroyWindow(window_); }

    void enter() override {
        previous_ = glfwGetCurrentContext();
        glfwMakeContextCurrent(window_);
    }
    void leave() override { glfwMakeContextCurrent(previous_); }

  private:
    GLFWwindow* window_ = hidden_window();
    GLFWwindow* previous_ = nullptr;
};

} // namespace

std::unique_ptr<OpenGlContext> make_opengl_context() {
    return std::make_unique<GlfwOpenGlContext>();
}

} // namespace rasterwalk
