#pragma once

#include <array>
#include <string>

#include "engines/fast/fast_engine.h"
#include "engines/opengl_task.h"

namespace rasterwalk {

/// Draws tasks with the OpenGL of the context that is current while this is made, used and ended.
///
/// A fragment shader writes three planes at once, into a framebuffer object: the colour, 1/z, and
/// the triangle's number. The depth buffer holds near / z, larger is nearer, so that it sorts as
/// the steps do.
class OpenGlDrawing {
  public:
    /// Throws AccessError if the context has no OpenGL 3.0.
    OpenGlDrawing();
    ~OpenGlDrawing();
    OpenGlDrawing(const OpenGlDrawing&) = delete;
    OpenGlDrawing& operator=(const OpenGlDrawing&) = delete;

    /// The renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& name() const { return name_; }

    /// Throws AccessError if OpenGL fails, or if picture or textures are too large for it.
    void draw(const OpenGlTask& task, FastPicture& picture);

  private:
    unsigned program_of(const OpenGlTask& task);

    std::string name_;
    int largest_side_ = 0, largest_texture_ = 0; ///< pixels, texels
    std::array<unsigned, 4> programs_{};         ///< 0: not made yet
};

} // namespace rasterwalk
