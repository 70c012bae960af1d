#include "pipeline/replay.h"

#include <algorithm>
#include <utility>

#include "pipeline/clearing.h"
#include "pipeline/square_steps.h"

namespace rasterwalk {

namespace {

/// Marks lie at least this far apart: the work of restoring a copy of 500 x 500 pixels.
constexpr double smallest_spacing = 50'000;

/// The copies made during the first pass are at least this far apart, and at least this part of the
/// frame: far enough that they hardly slow the drawing, and near enough that a jump back takes no
/// longer than the drawing did.
constexpr double first_pass_spacing = 500'000;
constexpr double first_pass_part = 1.0 / 3.0;

/// For more triangles than this it is not worth finding out which pixels have changed.
constexpr int most_triangles_checked = 8;

std::int64_t area(const Rectangle& r) {
    return static_cast<std::int64_t>(std::max(r.right - r.left, 0)) * std::max(r.bottom - r.top, 0);
}

Rectangle whole_picture(const Frame& frame) {
    return {0, 0, frame.settings.viewport.width, frame.settings.viewport.height};
}

/// A rectangle around the pixels that are resolved from one moment up to another.
Rectangle resolved_between(const Frame& frame, const Cursor& from, const Cursor& to) {
    const Rectangle whole = whole_picture(frame);
    const Cursor first = moment_of_resolve(0, 0);
    if (!frame.has_samples() || to <= first) return {};
    const Cursor begin = std::max(from, first);
    const Cursor end = std::min(to, moment_of_resolve(whole.bottom, 0));
    if (end.index > begin.index)
        return {0, begin.index, whole.right, std::min(end.index + 1, whole.bottom)};
    return {begin.step, begin.index, std::min(end.step, whole.right), begin.index + 1};
}

/// A rectangle around what is drawn in the squares from one moment up to another.
Rectangle squares_between(const WarnockSquares& squares, const Cursor& from, const Cursor& to) {
    Rectangle around_all;
    for (int n = square_at(squares, from); n < squares.count() && moment_of_square(n) < to; ++n)
        if (squares[n].surface >= 0) around_all = around(around_all, squares[n].pixels);
    return around_all;
}

} // namespace

void Replay::begin(const Frame& frame) {
    frame_ = &frame;
    work_.begin(frame);
    begin_clear();
}

void Replay::begin(const Frame& frame, FrameWork& work) {
    frame_ = &frame;
    std::swap(work_, work);
    work_.follow(frame);
    begin_clear();
}

/// The framebuffer waits to be cleared, if that is all that has to be done.
void Replay::begin_clear() {
    cursor_ = tallied_ = cursor_begin;
    tally_ = {};
    has_stepped_back_ = false;
    // Old pixels stay for a while, and their owners must be triangles of this frame too.
    const bool may_wait = framebuffer_.size == frame_->settings.viewport &&
                          framebuffer_.rules == picture_rules(*frame_) &&
                          owners_ == frame_->triangle_count();
    if (may_wait) {
        uncleared_ = around(uncleared_, touched_);
    } else {
        owners_ = -1; // if memory runs out here, the next frame is cleared completely
        clear(framebuffer_, *frame_);
        uncleared_ = {};
        begun_ = whole_picture(*frame_);
    }
    owners_ = frame_->triangle_count();
    touched_ = {};
    place_marks();
}

/// The first rows of what is left to clear.
void Replay::clear_some(const WorkLimit& limit) {
    const Viewport left{uncleared_.right - uncleared_.left, uncleared_.bottom - uncleared_.top};
    Rectangle part = uncleared_;
    part.bottom = part.top + rows_within(limit, clear_pixel_work, left, 0);
    clear_part(framebuffer_, part);
    changed_ = around(changed_, part);
    uncleared_.top = part.bottom;
    if (is_empty(uncleared_)) uncleared_ = {};
}

void Replay::place_marks() {
    const std::size_t bytes = framebuffer_.bytes();
    const std::size_t room = bytes > 0 ? budget_ / bytes : 0;
    for (Mark& mark : marks_) {
        if (mark.is_saved()) spare_.push_back(std::move(mark.copy));
    }
    marks_.clear();
    const bool fit = !spare_.empty() && spare_.front().bytes() == bytes;
    if (!fit || spare_.size() > room) spare_.clear();
    if (room == 0) return;
    const double total = work_.total();
    const double spacing = std::max(smallest_spacing, total / (static_cast<double>(room) + 1.0));
    const double first_pass = std::max(first_pass_spacing, first_pass_part * total);
    double last = 0.0; // work before the last mark laid in the first pass
    for (double next = spacing; next < total && marks_.size() < room; next += spacing) {
        Mark mark;
        mark.cursor = work_.at(next);
        mark.in_first_pass = next - last >= first_pass;
        if (mark.in_first_pass) last = next;
        marks_.push_back(std::move(mark));
    }
}

bool Replay::is_deferred(const Cursor& cursor, const WorkLimit& limit) const {
    return work_.before(cursor) - work_.before(cursor_) > limit.most;
}

const Framebuffer& Replay::toward(const Cursor& cursor, const WorkLimit& limit) {
    changed_ = std::exchange(begun_, Rectangle{});
    if (!is_clear()) clear_some(limit);
    if (!is_clear() || is_deferred(cursor, limit)) return framebuffer_;
    const Mark* const mark = last_saved(cursor);
    const Cursor before = cursor_;
    // If memory runs out while it draws, any pixel may have been touched.
    const Rectangle touched_before = std::exchange(touched_, whole_picture(*frame_));
    if (cursor < cursor_) {
        go_back(cursor, mark, limit);
    } else if (mark != nullptr && mark->cursor > cursor_) {
        restore(whole_picture(*frame_), mark);
        cursor_ = mark->cursor;
    }
    save_keyframes_and_draw(part_end(cursor, limit));
    touched_ = touched_before;
    if (before != cursor_) {
        const Rectangle drawn =
            changed_between(std::min(before, cursor_), std::max(before, cursor_));
        changed_ = around(changed_, drawn);
        // A transposed depth buffer is written in other places.
        const bool is_in_place = framebuffer_.rules.depth_cell == PictureRules{}.depth_cell;
        touched_ = around(touched_, is_in_place ? drawn : whole_picture(*frame_));
    }
    return framebuffer_;
}

/// Back to the cursor, or to the mark before it.
void Replay::go_back(const Cursor& cursor, const Mark* mark, const WorkLimit& limit) {
    const Rectangle whole = whole_picture(*frame_);
    const Cursor from = mark != nullptr ? mark->cursor : cursor_begin;
    const bool is_little = work_.before(cursor) - work_.before(from) <= limit.at_once;
    const Rectangle changed = is_little ? changed_between(cursor, cursor_) : whole;
    restore(changed, mark);
    cursor_ = from;
    if (changed == whole) {
        has_stepped_back_ = true;
        return;
    }
    // All other pixels are already as they are at `cursor`.
    draw(*frame_, {from, cursor, changed}, framebuffer_);
    cursor_ = cursor;
}

/// How far toward the cursor the limit allows drawing; further than now, unless that is the cursor.
Cursor Replay::part_end(const Cursor& cursor, const WorkLimit& limit) const {
    const double begun = work_.before(cursor_), missing = work_.before(cursor) - begun;
    // In a large frame the last part is no larger than the others.
    const double part = limit.of(work_.total());
    if (part >= missing) return cursor;
    Cursor end = work_.at(begun + part);
    // If the estimate does not get further, a square is drawn, or a row, or the triangle to its
    // end.
    if (end <= cursor_ && frame_->squares != nullptr) {
        const int square = square_at(*frame_->squares, cursor_);
        end = cursor_at_square(*frame_->squares, square + 1);
    } else if (end <= cursor_) {
        const Cursor row{cursor_.triangle, cursor_.phase, cursor_.index + 1, 0};
        const bool has_rows = cursor_.phase == Phase::rows || cursor_.phase == Phase::resolve;
        const bool is_divided = has_rows && work_.before(row) > begun;
        end = is_divided ? row : Cursor{cursor_.triangle + 1, Phase::vertices, 0, 0};
    }
    return std::min(cursor, end);
}

/// The last mark with a copy at or before the cursor; null: there is none.
const Replay::Mark* Replay::last_saved(const Cursor& cursor) const {
    const Mark* last = nullptr;
    for (const Mark& mark : marks_) {
        if (mark.cursor > cursor) break;
        if (mark.is_saved()) last = &mark;
    }
    return last;
}

/// A rectangle with all pixels that the moments from `from` up to `to` can have changed; the whole
/// picture if it is not worth finding out.
Rectangle Replay::changed_between(const Cursor& from, const Cursor& to) const {
    const Rectangle whole = whole_picture(*frame_);
    if (frame_->squares != nullptr) {
        const Rectangle changed = squares_between(*frame_->squares, from, to);
        return 2 * area(changed) > area(whole) ? whole : changed;
    }
    const int first_triangle = std::max(from.triangle, 0);
    const int last_triangle = std::min(to.triangle, frame_->triangle_count() - 1);
    if (frame_->settings.stage < Stage::rows) return whole;
    if (last_triangle - first_triangle >= most_triangles_checked) return whole;
    const Rectangle resolved = resolved_between(*frame_, from, to);
    Rectangle box{whole.right, whole.bottom, 0, 0};
    PolygonRows rows;
    for (int t = first_triangle; t <= last_triangle; ++t) {
        // Neither vertices nor edge samples are drawn in these stages.
        const Cursor rows_begin{t, Phase::rows, 0, 0};
        if (!frame_->is_drawn(t) || to <= rows_begin) continue;
        compute_rows(*frame_, t, rows, nullptr, {});
        const Cursor begin = std::max(from, rows_begin);
        const int first = std::max(begin.index, -rows.first_row);
        const int last_shown = std::min(rows.size(), whole.bottom - rows.first_row) - 1;
        const int last = to.triangle == t ? std::min(to.index, last_shown) : last_shown;
        const bool is_one_row =
            has_fragments(frame_->settings.stage) && to.triangle == t && to.index == begin.index;
        for (int r = first; r <= last; ++r) {
            if (rows.is_empty_row(r)) continue;
            const RowSpan span = row_span(frame_->stages, rows, r);
            const int begun = is_one_row ? std::clamp(begin.step, 0, span.count) : 0;
            const int ended = is_one_row ? std::clamp(to.step, 0, span.count) : span.count;
            box.left = std::min(box.left, span.left + begun);
            box.right = std::max(box.right, span.left + ended);
            box.top = std::min(box.top, rows.first_row + r);
            box.bottom = std::max(box.bottom, rows.first_row + r + 1);
        }
    }
    const Rectangle drawn{
        std::clamp(box.left, 0, whole.right), std::clamp(box.top, 0, whole.bottom),
        std::clamp(box.right, 0, whole.right), std::clamp(box.bottom, 0, whole.bottom)};
    const Rectangle changed = around(drawn, resolved);
    return 2 * area(changed) > area(whole) ? whole : changed;
}

/// Gives the pixels the values of a mark's copy; if it is null, those of the beginning.
void Replay::restore(const Rectangle& pixels, const Mark* mark) {
    if (pixels.left >= pixels.right) return;
    if (mark == nullptr) {
        clear_part(framebuffer_, pixels);
        return;
    }
    const auto count = static_cast<std::size_t>(pixels.right - pixels.left);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
        const auto first = static_cast<std::ptrdiff_t>(framebuffer_.at(pixels.left, row));
        for_each_plane_pair(framebuffer_, mark->copy, [&](auto& plane, const auto& from) {
            std::copy_n(from.begin() + first, count, plane.begin() + first);
        });
    }
}

/// One whose memory can be used, or an empty one.
Framebuffer Replay::spare_copy() {
    if (spare_.empty()) return {};
    Framebuffer copy = std::move(spare_.back());
    spare_.pop_back();
    return copy;
}

/// Draws from where the framebuffer is to the cursor, making copies on the way.
void Replay::save_keyframes_and_draw(const Cursor& cursor) {
    Mark* last_passed = nullptr;
    for (Mark& mark : marks_) {
        if (mark.cursor > cursor_ && mark.cursor <= cursor && !mark.is_saved()) last_passed = &mark;
    }
    for (Mark& mark : marks_) {
        if (mark.cursor <= cursor_ || mark.cursor > cursor || mark.is_saved()) continue;
        // One per call, the one nearest to the user's place.
        const bool is_wanted = mark.in_first_pass || (has_stepped_back_ && &mark == last_passed);
        if (!is_wanted) continue;
        draw_on(mark.cursor);
        mark.copy = spare_copy();
        mark.copy = framebuffer_;
    }
    draw_on(cursor);
}

/// Draws from where the framebuffer is to the cursor.
void Replay::draw_on(const Cursor& cursor) {
    if (cursor_ < tallied_) {
        const Cursor to = std::min(cursor, tallied_);
        draw(*frame_, {cursor_, to, {}}, framebuffer_);
        cursor_ = to;
    }
    if (cursor_ < cursor) {
        tally_ += draw(*frame_, {cursor_, cursor, {}}, framebuffer_);
        cursor_ = tallied_ = cursor;
    }
}

std::size_t Replay::keyframe_count() const {
    return static_cast<std::size_t>(
        std::count_if(marks_.begin(), marks_.end(), [](const Mark& m) { return m.is_saved(); }));
}

std::size_t Replay::keyframe_bytes() const {
    std::size_t bytes = 0;
    for (const Mark& mark : marks_)
        bytes += mark.copy.bytes();
    for (const Framebuffer& copy : spare_)
        bytes += copy.bytes();
    return bytes;
}

} // namespace rasterwalk
