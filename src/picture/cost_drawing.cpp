#include "picture/cost_drawing.h"

#include <algorithm>

#include "pipeline/clearing.h"
#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

/// The work of counting a fragment, relative to drawing it.
constexpr double counting_work = 4.0;

/// The work of counting a vertex, relative to a fragment: its light and its shadow once more.
constexpr double vertex_work = 40.0;

/// A pixel of the counts is about as much memory as one of the framebuffer, and both are cleared.
constexpr double planes_cleared = 2.0;

} // namespace

bool CostDrawing::count(const Frame& frame, const FrameWork& work, std::uint64_t number,
                        const Cursor& cursor, const WorkLimit& limit) {
    const bool is_same = number_ == number;
    if (is_same && cursor == to_ && !is_counting()) return false;
    // If memory runs out on the way, all of it is counted again next time.
    number_ = std::nullopt;
    if (!is_same || cursor < at_) restart(frame);
    to_ = cursor;
    if (begin(frame, limit)) advance(frame, work, limit);
    number_ = number;
    return true;
}

void CostDrawing::restart(const Frame& frame) {
    begin_clearing(framebuffer_, frame);
    const Viewport size = frame.settings.viewport;
    pixels_.clear();
    pixels_.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    cost_ = {};
    vertices_ = 0;
    has_begun_ = false;
    at_ = cursor_begin;
}

/// Continues what comes before the drawing. False: that is enough for one call.
bool CostDrawing::begin(const Frame& frame, const WorkLimit& limit) {
    if (has_begun_) return true;
    const std::size_t count = frame.shaded.size();
    if (vertices_ < count) {
        const double part = limit.of(vertex_work * static_cast<double>(count)) / vertex_work;
        const std::size_t left = count - vertices_;
        const std::size_t taken = part < static_cast<double>(left)
                                      ? std::max(static_cast<std::size_t>(part), std::size_t{1})
                                      : left;
        add_vertex_cost(frame, vertices_, vertices_ + taken, cost_);
        vertices_ += taken;
        if (taken < count) return false;
    }
    const bool is_first_part = framebuffer_.owner.empty();
    has_begun_ = clear_rows(
        framebuffer_, {limit.at_once / planes_cleared, limit.slice / planes_cleared, limit.most});
    pixels_.resize(framebuffer_.owner.size());
    return has_begun_ && is_first_part;
}

void CostDrawing::advance(const Frame& frame, const FrameWork& work, const WorkLimit& limit) {
    const double begun = work.before(at_), missing = work.before(to_) - begun;
    Cursor end = to_;
    if (counting_work * missing > limit.at_once) {
        // A triangle may be more than a slice.
        double slice = std::max(limit.slice / counting_work, 1.0);
        do {
            end = std::min(work.at(begun + slice), to_);
            slice *= 2.0;
        } while (end <= at_ && end < to_);
    }
    if (end > at_) add_cost(frame, at_, end, framebuffer_, cost_, &pixels_);
    at_ = end;
}

} // namespace rasterwalk
