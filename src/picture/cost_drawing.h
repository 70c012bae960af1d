#pragma once

// The cost of a picture so far, for the overlay: counted in parts, and on from where it is.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/draw_cost.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// What everything before a moment took. Going forward, counting continues from there.
class CostDrawing {
  public:
    /// Counts up to the cursor, as far as the limit allows.
    /// @param work   of this frame
    /// @param number of the frame: changes whenever the frame does
    /// @return has anything been counted?
    bool count(const Frame& frame, const FrameWork& work, std::uint64_t number,
               const Cursor& cursor, const WorkLimit& limit);

    /// Is there more to count than the limit allowed?
    bool is_counting() const { return number_ && !(has_begun_ && at_ == to_); }
    /// Is everything up to the cursor counted?
    bool is_counted() const { return number_ && !is_counting(); }

    /// All that is counted so far.
    const DrawCost& cost() const { return cost_; }
    /// Row by row from the top; complete only if is_counted().
    const std::vector<PixelCost>& pixels() const { return pixels_; }

  private:
    void restart(const Frame& frame);
    bool begin(const Frame& frame, const WorkLimit& limit);
    void advance(const Frame& frame, const FrameWork& work, const WorkLimit& limit);

    std::optional<std::uint64_t> number_; ///< of the frame; none: nothing is counted
    std::size_t vertices_ = 0;            ///< so many are counted, before anything is drawn
    bool has_begun_ = false;              ///< all of them are, and every pixel is cleared
    Cursor at_, to_;                      ///< counted up to here, and to be counted up to here
    Framebuffer framebuffer_;
    DrawCost cost_;
    std::vector<PixelCost> pixels_;
};

} // namespace rasterwalk
