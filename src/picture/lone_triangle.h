#pragma once

// One triangle drawn as if there were no other. This is also a way to look for a mistake in your
// own program.

#include <cstdint>
#include <optional>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// One triangle of a frame, up to a moment. Going forward, drawing continues from there.
class LoneTriangle {
  public:
    /// Draws what the pipeline draws of the triangle up to the cursor, as far as the limit allows.
    /// @param work   of this frame
    /// @param number of the frame: changes whenever the frame does
    /// @return has it changed?
    bool draw(const Frame& frame, const FrameWork& work, std::uint64_t number, int triangle,
              const Cursor& cursor, const WorkLimit& limit);

    /// Is there more to draw than the limit allowed?
    bool is_drawing() const { return triangle_ && at_ < to_; }

    std::optional<int> triangle() const { return triangle_; }
    /// Its planes; they have no pixels before it is drawn.
    const Framebuffer& picture() const { return picture_; }
    std::int64_t pixels() const { return pixels_; } ///< how many it has

  private:
    std::uint64_t number_ = 0;
    std::optional<int> triangle_;
    Cursor at_, to_; ///< drawn up to here, and to be drawn up to here
    Framebuffer picture_;
    std::int64_t pixels_ = 0;
};

} // namespace rasterwalk
