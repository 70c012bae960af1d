#pragma once

// What is drawn of one triangle, as if there were no other: a way to look for a mistake in one's
// own program, too.

#include <cstdint>
#include <optional>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// One triangle of a frame, up to a moment. Forwards it is drawn on from where it stands.
class LoneTriangle {
  public:
    /// Goes toward everything that the pipeline draws of the triangle up to the cursor, as far as
    /// the limit allows.
    /// @param work   of this frame
    /// @param number of the frame: another one whenever it is another
    /// @return has it changed?
    bool draw(const Frame& frame, const FrameWork& work, std::uint64_t number, int triangle,
              const Cursor& cursor, const WorkLimit& limit);

    /// Is there more to draw than the limit allowed?
    bool is_drawing() const { return triangle_ && at_ < to_; }

    std::optional<int> triangle() const { return triangle_; }
    /// Its planes; without pixels before it is drawn.
    const Framebuffer& picture() const { return picture_; }
    std::int64_t pixels() const { return pixels_; } ///< that it has

  private:
    std::uint64_t number_ = 0;
    std::optional<int> triangle_;
    Cursor at_, to_; ///< everything before is drawn, and is to be drawn
    Framebuffer picture_;
    std::int64_t pixels_ = 0;
};

} // namespace rasterwalk
