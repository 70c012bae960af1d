#pragma once

// Two runs drawn in parallel, triangle by triangle, and what each does at every moment. Keeps the
// work of a few rows, never that of a frame.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/observer.h"

namespace rasterwalk {

/// First and last row of the row table of a drawn triangle, by its vertices.
struct TableRows {
    int first = 0, last = 0;
};
TableRows table_rows(const Frame& frame, int triangle);

/// A vertex at the moment it is projected.
struct VertexEvent {
    Cursor cursor;
    ScreenVertex pixel;                    ///< valid if has_pixel
    bool has_pixel = false;                ///< it can be projected
    Rejection rejection = Rejection::none; ///< why not
    Varyings varyings;                     ///< as q, however the run carries them
    VaryingSet compared;                   ///< those that the run carries
};

/// What one run does at one moment; the rest is null or empty.
struct MomentEvents {
    const VertexEvent* vertex = nullptr;
    const ClipEvent* clip = nullptr;
    const CullEvent* cull = nullptr;
    const SampleEvent* sample = nullptr;
    const TestEvent* test = nullptr;
    std::span<const FragmentEvent> fragments; ///< and marks; both ends of a row are one moment

    /// A triangle that is tested and faces the camera goes on as if it had not been tested.
    bool is_culled() const { return cull != nullptr && cull->test.is_back; }
    bool is_nothing() const {
        return vertex == nullptr && clip == nullptr && !is_culled() && sample == nullptr &&
               test == nullptr && fragments.empty();
    }
};

/// A moment at which at least one of the runs does something.
struct PairMoment {
    Cursor cursor;
    MomentEvents a, b;
};

/// Called for every moment, in order; false ends the walk.
using PairVisitor = std::function<bool(const PairMoment&)>;

/// Everything that a run does in a part of a frame, in order.
class EventRecorder : public Observer {
  public:
    /// @param frame must outlive this
    explicit EventRecorder(const Frame& frame) : frame_(frame) {}

    void clear();
    void vertex(const Cursor& cursor, const ProjectedVertex& vertex) override;
    void clip_step(const ClipEvent& event) override { clips_.push_back(event); }
    void cull(const CullEvent& event) override { culls_.push_back(event); }
    void edge_sample(const SampleEvent& event) override { samples_.push_back(event); }
    void pixel_test(const TestEvent& event) override { tests_.push_back(event); }
    void fragment(const FragmentEvent& event) override { fragments_.push_back(event); }
    bool wants_edge_samples() const override { return true; }
    bool wants_pixel_tests() const override { return true; }
    bool wants_clipping() const override { return true; }

    /// How many moments there are; for a row without fragments, both ends.
    std::size_t count() const {
        return vertices_.size() + clips_.size() + culls_.size() + samples_.size() + tests_.size() +
               fragments_.size();
    }

    /// The next moment that has not been taken; the end if all have been.
    Cursor next() const;
    /// The events of that moment, which must not be before next().
    MomentEvents take(const Cursor& cursor);

  private:
    const Frame& frame_;
    std::vector<VertexEvent> vertices_;
    std::vector<ClipEvent> clips_;
    std::vector<CullEvent> culls_;
    std::vector<SampleEvent> samples_;
    std::vector<TestEvent> tests_;
    std::vector<FragmentEvent> fragments_;
    /// The next one of each list.
    std::size_t vertex_ = 0, clip_ = 0, cull_ = 0, sample_ = 0, test_ = 0, fragment_ = 0;
};

/// The pictures of two runs, side by side.
struct RunPictures {
    Framebuffer a, b;
};

/// A walk through two runs of the same scene, with viewports of the same size.
class RunWalk {
  public:
    /// @param a, b must outlive this
    /// @param to   nothing is drawn from there onward
    RunWalk(const Frame& a, const Frame& b, const Cursor& to);
    /// The same in pictures that are already clear.
    RunWalk(const Frame& a, const Frame& b, const Cursor& to, RunPictures pictures);

    /// Hands the pictures out, so that their memory can be reused; no other call may follow.
    RunPictures take_pictures() { return std::move(pictures_); }

    /// Draws everything before this triangle without reporting it.
    void skip_to(int triangle);

    /// Draws the next part, a triangle or some rows of a large one or of its box, and reports every
    /// moment. False if the visitor has ended the walk.
    bool walk_part(const PairVisitor& visit);

    bool is_done() const;

    /// The triangle that the next part belongs to.
    int triangle() const { return next_.triangle; }

    /// How many moments of both runs have been drawn and reported, plus the rows of tables made for
    /// them.
    std::int64_t work() const { return work_; }

    /// The pictures so far.
    const Framebuffer& picture_a() const { return pictures_.a; }
    const Framebuffer& picture_b() const { return pictures_.b; }

  private:
    Cursor part_end() const;
    std::optional<Cursor> part_end_in_box() const;

    const Frame& a_;
    const Frame& b_;
    Cursor to_;
    Cursor next_ = cursor_begin; ///< where the next part begins
    std::int64_t work_ = 0;
    RunPictures pictures_;
    EventRecorder recorder_a_, recorder_b_;
};

/// Reports what both runs do at one moment, without drawing anything before it: the pictures are
/// already there. Calls the visitor unless neither does anything.
/// @param scratch room for what the moment draws; kept by the caller to save allocations
void visit_moment(const Frame& a, const Framebuffer& picture_a, const Frame& b,
                  const Framebuffer& picture_b, const Cursor& cursor, Framebuffer& scratch,
                  const PairVisitor& visit);

} // namespace rasterwalk
