#pragma once

// Two runs played in parallel, triangle by triangle, and what each does at every moment. Keeps the
// work of a few rows, never that of a frame.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "pipeline/event_source.h"

namespace rasterwalk {

/// First and last row of the row table of a drawn triangle, by its vertices.
struct TableRows {
    int first = 0, last = 0;
};
TableRows table_rows(const Frame& frame, int triangle);

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

/// Events in order of time, from the first to the last.
template <class Told>
struct EventQueue {
    std::vector<Told> all;
    std::size_t next = 0; ///< that has not been taken

    /// The next moment; the end if all have been taken.
    const Cursor& moment() const {
        if (next == all.size()) return cursor_end;
        if constexpr (std::is_same_v<Told, Event>)
            return cursor_of(all[next]);
        else
            return all[next].cursor;
    }
    /// Takes those of a moment, which must not be before the next.
    std::span<const Told> take(const Cursor& cursor) {
        const std::size_t first = next;
        while (next < all.size() && moment() == cursor)
            ++next;
        return std::span(all).subspan(first, next - first);
    }
    /// Empties it, and keeps its memory.
    void clear() {
        all.clear();
        next = 0;
    }
};

/// What a run does in a part of a frame. The kinds with many events are kept apart, in less memory.
struct PartEvents {
    EventQueue<Event> others;
    EventQueue<TestEvent> tests;
    EventQueue<FragmentEvent> fragments; ///< and marks

    const Cursor& next() const {
        return std::min(others.moment(), std::min(tests.moment(), fragments.moment()));
    }
    /// The events of a moment, which must not be before next().
    MomentEvents take(const Cursor& cursor);
};

/// A walk through two runs of the same scene, with viewports of the same size.
class RunWalk {
  public:
    /// @param to nothing is played from there onward
    RunWalk(EventSource a, EventSource b, const Cursor& to);

    /// Leaves out everything before this triangle.
    void skip_to(int triangle);

    /// Plays the next part, a triangle or some rows of a large one or of its box, and reports every
    /// moment. False if the visitor has ended the walk.
    bool walk_part(const PairVisitor& visit);

    bool is_done() const;

    /// The triangle that the next part belongs to.
    int triangle() const { return next_.triangle; }

    /// How many moments of both runs have been played and reported, plus the rows of tables made
    /// for them.
    std::int64_t work() const { return work_; }

  private:
    Cursor part_end() const;
    std::optional<Cursor> part_end_in_box() const;

    EventSource source_a_, source_b_;
    const Frame& a_;
    const Frame& b_;
    Cursor to_;
    Cursor next_ = cursor_begin; ///< where the next part begins
    std::int64_t work_ = 0;
    PartEvents events_a_, events_b_; ///< of the part; kept to save allocations
};

/// Reports what both runs do at one moment, without drawing anything before it: the pictures are
/// already there. Calls the visitor unless neither does anything.
/// @param scratch room for what the moment draws; kept by the caller to save allocations
void visit_moment(const Frame& a, const Framebuffer& picture_a, const Frame& b,
                  const Framebuffer& picture_b, const Cursor& cursor, Framebuffer& scratch,
                  const PairVisitor& visit);

} // namespace rasterwalk
