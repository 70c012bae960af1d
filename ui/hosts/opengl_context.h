#pragma once

#include <memory>

namespace rasterwalk {

/// A context of OpenGL of its own, so that drawing in it leaves the interface's untouched.
class OpenGlContext {
  public:
    virtual ~OpenGlContext() = default;
    /// Makes it current.
    virtual void enter() = 0;
    /// Makes the one current that was before enter().
    virtual void leave() = 0;
};

/// The host's: a window that is never shown, or memory. The current context stays current. Throws
/// AccessError.
std::unique_ptr<OpenGlContext> make_opengl_context();

} // namespace rasterwalk
