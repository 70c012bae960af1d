#pragma once

#include <string>

#include "engines/fast/fast_engine.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Draws scenes with OpenGL. `src` has no OpenGL: a host that has a context passes one, see
/// set_opengl_engine().
class OpenGlEngine {
  public:
    virtual ~OpenGlEngine() = default;
    /// The renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
    virtual std::string name() const = 0;
    /// Why it cannot draw anything: a sentence, without the full stop. Empty if it can, as far as
    /// is known before it has drawn.
    virtual std::string refusal() const { return {}; }
    /// Draws the whole picture with its planes: colour bytes, 1/z, owner. Settings that
    /// opengl_refuses() names are ignored. Throws AccessError if OpenGL fails (no memory, lost
    /// context, too large).
    /// @param picture its memory is reused
    virtual void draw(const Scene& scene, const Settings& settings, FastPicture& picture) = 0;
};

/// What this program draws with; null: it has no OpenGL. The host owns it and sets null before it
/// goes.
void set_opengl_engine(OpenGlEngine* engine);
OpenGlEngine* opengl_engine();

/// While it exists, the program draws with an engine; after that with the previous one.
class UsedOpenGl {
  public:
    explicit UsedOpenGl(OpenGlEngine& engine);
    ~UsedOpenGl();
    UsedOpenGl(const UsedOpenGl&) = delete;
    UsedOpenGl& operator=(const UsedOpenGl&) = delete;

  private:
    OpenGlEngine* previous_;
};

/// Why OpenGL cannot draw this: a sentence, without the full stop: "OpenGL does not support ...",
/// or "this program has no OpenGL". Empty if it can.
std::string opengl_refuses(const Scene& scene, const Settings& settings);

} // namespace rasterwalk
