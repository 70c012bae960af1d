#pragma once

// OpenGL for programs without it: `rasterwalk-llvmpipe opengl` draws. The two exchange lines and
// bytes:
//
//   it says when it is ready      "ready NAME"
//   asked "draw COUNT", and COUNT bytes of an OpenGlTask
//       draws, says "planes WIDTH HEIGHT", then for each plane, colour, 1/z and owner, four bytes
//       a pixel; or "fault SENTENCE"
//   at the end of its input       ends

#include <memory>
#include <string>

#include "base/child_process.h"
#include "engines/opengl_engine.h"

namespace rasterwalk {

/// The word after the program's name that makes it draw.
inline constexpr const char* opengl_peer_word = "opengl";

/// A picture as bytes of its planes, and back: `picture` has the size. Throws AccessError if the
/// number of bytes is wrong.
std::string bytes_of_planes(const FastPicture& picture);
void set_planes(const std::string& bytes, FastPicture& picture);

/// OpenGL in another program, which is started for the first picture and then kept.
class PeerOpenGl final : public OpenGlEngine {
  public:
    /// @param program its path: llvmpipe_program()
    explicit PeerOpenGl(std::string program);

    /// Starts the program, if it is not running. Throws AccessError.
    std::string name() const override;
    /// Is the program missing?
    std::string refusal() const override;
    void draw(const Scene& scene, const Settings& settings, FastPicture& picture) override;

  private:
    void start() const;

    std::string program_;
    bool exists_ = false;
    mutable std::unique_ptr<ChildProcess> child_; ///< null: it is not running
    mutable std::string name_;
};

} // namespace rasterwalk
