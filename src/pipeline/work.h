#pragma once

// How much work it is to draw a frame, estimated from its vertices without drawing it. The unit is
// the work of one fragment, some 10 to 20 nanoseconds.

#include <limits>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// How much one call of a function may do: it does work estimated at no more than `at_once`
/// completely, of anything larger only a part of about `slice`, and does not begin work of more
/// than `most` at all. Without limits: everything.
struct WorkLimit {
    double at_once = std::numeric_limits<double>::infinity();
    double slice = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    /// How much of this work one call may do.
    double of(double work) const { return work <= at_once ? work : slice; }
};

/// How many rows of a picture one call may handle.
/// @param of_pixel the work of a pixel
/// @param done     rows that are done
/// @return at least one, if any are left
int rows_within(const WorkLimit& limit, double of_pixel, Viewport size, int done);

/// The limit of each kind of work in one update of the window: the lessons' scenes are drawn in one
/// go, larger ones about a hundredth of a second at a time. An update does several kinds, and
/// should take no longer than 50 milliseconds.
inline constexpr WorkLimit frame_limit{.at_once = 1'000'000.0, .slice = 1'000'000.0};

/// How many fragments a frame makes, estimated from the areas of its triangles.
struct FragmentEstimate {
    double all = 0.0;        ///< all that are walked: of whole triangles, as in the lab's loop
    double in_picture = 0.0; ///< only those in the picture, which are drawn

    double share_outside() const { return all > 0.0 ? 1.0 - in_picture / all : 0.0; }
};

/// The work of a frame, triangle by triangle, or square by square.
class FrameWork {
  public:
    /// Estimates the work of this frame, which must live as long as this is used.
    void begin(const Frame& frame);

    /// The same in parts: empties it, and then estimates as much of the frame as the limit allows.
    void start(const Frame& frame);
    void advance(const WorkLimit& limit = {});
    bool is_done() const;

    /// The frame has been moved here.
    void follow(const Frame& frame) { frame_ = &frame; }

    double total() const { return before_.empty() ? 0.0 : before_.back(); }

    /// None in a stage that draws only marks.
    const FragmentEstimate& fragments() const { return fragments_; }

    /// The work of everything before the cursor.
    double before(const Cursor& cursor) const;

    /// A cursor with about this much work before it: at the beginning of a triangle, or of a row of
    /// a large one, or at a square. The end if the frame has no more than that.
    Cursor at(double work) const;

  private:
    int count() const;
    double add(int number);

    const Frame* frame_ = nullptr;
    FragmentEstimate fragments_;
    std::vector<double> before_; ///< work of all earlier units of time, see time_units(); one entry
                                 ///< more than there are
};

} // namespace rasterwalk
