#include "pipeline/replay.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

// Work is counted in fragments: one takes about 20 nanoseconds.

/// Marks lie at least this far apart: as much as it takes to put back a copy of 500 x 500 pixels.
constexpr double smallest_spacing = 50'000;

/// So far apart are the copies that are laid on the first way: far enough for the drawing of a
/// frame not to be much slower for them, and near enough for a jump back to seem immediate.
constexpr double first_way_spacing = 500'000;

/// What an edge sample, and a triangle by itself, cost beside a fragment.
constexpr double sample_work = 2;
constexpr double triangle_work = 20;

/// Triangles of more work than this may have a mark within.
constexpr double large_triangle = 5'000;

/// Over more triangles than this it is not worth asking which pixels have changed.
constexpr int most_triangles_asked = 8;

struct Box {
    double left, top, right, bottom;

    double width() const { return std::max(right - left, 0.0); }
    double height() const { return std::max(bottom - top, 0.0); }
    double area() const { return width() * height(); }
};

Box box_of(std::span<const Fragment> v) {
    Box box{1e9, 1e9, -1e9, -1e9};
    for (const Fragment& vertex : v) {
        box.left = std::min(box.left, static_cast<double>(vertex.column));
        box.right = std::max(box.right, vertex.column + 1.0);
        box.top = std::min(box.top, static_cast<double>(vertex.row));
        box.bottom = std::max(box.bottom, vertex.row + 1.0);
    }
    return box;
}

Box in_picture(const Box& box, Viewport picture) {
    return {std::max(box.left, 0.0), std::max(box.top, 0.0),
            std::min(box.right, static_cast<double>(picture.width)),
            std::min(box.bottom, static_cast<double>(picture.height))};
}

/// Of a polygon without dents, as a fan of triangles about its first corner.
double twice_the_area(std::span<const Fragment> v) {
    double area = 0.0;
    for (std::size_t i = 2; i < v.size(); ++i) {
        const glm::dvec2 p(v[i - 1].column - v[0].column, v[i - 1].row - v[0].row);
        const glm::dvec2 q(v[i].column - v[0].column, v[i].row - v[0].row);
        area += std::abs(p.x * q.y - p.y * q.x);
    }
    return area;
}

/// An estimate of what it takes to draw a triangle. Its box is taken to be filled evenly.
double work_of(const Frame& frame, int triangle) {
    if (!frame.is_drawn(triangle)) return 0.0;
    const std::span<const Fragment> v = frame.triangle_vertices(triangle);
    const Box box = box_of(v);
    const double samples = 2.0 * std::max(box.width(), box.height());
    double fragments = 0.0;
    if (has_fragments(frame.settings.stage)) {
        fragments = (twice_the_area(v) + samples) / 2.0;
        fragments *= in_picture(box, frame.settings.viewport).area() / box.area();
    }
    return triangle_work + sample_work * samples + fragments;
}

/// A moment within a triangle, at the beginning of a row, with this share of its work before it.
Cursor moment_within(const Frame& frame, int triangle, double share) {
    const Box box = box_of(frame.triangle_vertices(triangle));
    const Box shown = in_picture(box, frame.settings.viewport);
    const double row = shown.top - box.top + share * shown.height();
    return {triangle, Phase::rows, static_cast<int>(row), 0};
}

std::int64_t area(const Rectangle& r) {
    return static_cast<std::int64_t>(std::max(r.right - r.left, 0)) * std::max(r.bottom - r.top, 0);
}

Rectangle whole_picture(const Frame& frame) {
    return {0, 0, frame.settings.viewport.width, frame.settings.viewport.height};
}

} // namespace

void Replay::begin(const Frame& frame) {
    frame_ = &frame;
    cursor_ = cursor_begin;
    has_gone_back_ = false;
    clear(framebuffer_, frame);
    place_marks();
}

void Replay::place_marks() {
    marks_.clear();
    const std::size_t bytes = framebuffer_.bytes();
    const std::size_t room = bytes > 0 ? budget_ / bytes : 0;
    if (room == 0) return;
    double total = 0.0;
    for (int t = 0; t < frame_->triangle_count(); ++t)
        total += work_of(*frame_, t);
    const double spacing = std::max(smallest_spacing, total / (static_cast<double>(room) + 1.0));
    double before = 0.0;    // work of the triangles before t
    double first_way = 0.0; // work before the last mark that is laid on the first way
    double next = spacing;  // work before the next mark
    for (int t = 0; t < frame_->triangle_count() && marks_.size() < room; ++t) {
        const double work = work_of(*frame_, t);
        const bool is_large = work > large_triangle && has_fragments(frame_->settings.stage);
        for (; next < before + work && marks_.size() < room; next += spacing) {
            Mark mark;
            mark.cursor = is_large ? moment_within(*frame_, t, (next - before) / work)
                                   : Cursor{t, Phase::vertices, 0, 0};
            mark.on_first_way = next - first_way >= first_way_spacing;
            if (mark.on_first_way) first_way = next;
            marks_.push_back(std::move(mark));
        }
        before += work;
    }
}

const Framebuffer& Replay::at(const Cursor& cursor) {
    const Mark* const mark = last_laid(cursor);
    if (cursor < cursor_) {
        const Rectangle whole = whole_picture(*frame_);
        const Rectangle changed = changed_between(cursor, cursor_);
        restore(changed, mark);
        cursor_ = mark != nullptr ? mark->cursor : cursor_begin;
        if (!(changed == whole)) {
            // All other pixels are as they are at `cursor` already.
            draw(*frame_, {cursor_, cursor, changed}, framebuffer_);
            cursor_ = cursor;
            return framebuffer_;
        }
        has_gone_back_ = true;
    } else if (mark != nullptr && mark->cursor > cursor_) {
        restore(whole_picture(*frame_), mark);
        cursor_ = mark->cursor;
    }
    draw_on(cursor);
    return framebuffer_;
}

/// The last mark with a copy that is not after the cursor; null: there is none.
const Replay::Mark* Replay::last_laid(const Cursor& cursor) const {
    const Mark* last = nullptr;
    for (const Mark& mark : marks_) {
        if (mark.cursor > cursor) break;
        if (mark.is_laid()) last = &mark;
    }
    return last;
}

/// A rectangle with all pixels that the moments from `from` up to `to` can have changed; the whole
/// picture where it is not worth asking.
Rectangle Replay::changed_between(const Cursor& from, const Cursor& to) const {
    const Rectangle whole = whole_picture(*frame_);
    const int first_triangle = std::max(from.triangle, 0);
    const int last_triangle = std::min(to.triangle, frame_->triangle_count() - 1);
    if (frame_->settings.stage < Stage::rows) return whole;
    if (last_triangle - first_triangle >= most_triangles_asked) return whole;
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
            const int count = rows.pixel_count(r), left = rows.left[r].column;
            const int begun = is_one_row ? std::clamp(begin.step, 0, count) : 0;
            const int ended = is_one_row ? std::clamp(to.step, 0, count) : count;
            box.left = std::min(box.left, left + begun);
            box.right = std::max(box.right, left + ended);
            box.top = std::min(box.top, rows.first_row + r);
            box.bottom = std::max(box.bottom, rows.first_row + r + 1);
        }
    }
    const Rectangle changed{
        std::clamp(box.left, 0, whole.right), std::clamp(box.top, 0, whole.bottom),
        std::clamp(box.right, 0, whole.right), std::clamp(box.bottom, 0, whole.bottom)};
    return 2 * area(changed) > area(whole) ? whole : changed;
}

/// Gives the pixels the values of a mark's copy; of the beginning, where it is null.
void Replay::restore(const Rectangle& pixels, const Mark* mark) {
    if (pixels.left >= pixels.right) return;
    const auto count = static_cast<std::size_t>(pixels.right - pixels.left);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
        const std::size_t first = framebuffer_.at(pixels.left, row);
        const auto put_back = [&](auto& plane, const auto& from, auto empty) {
            if (mark != nullptr) {
                std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), count,
                            plane.begin() + static_cast<std::ptrdiff_t>(first));
            } else {
                std::fill_n(plane.begin() + static_cast<std::ptrdiff_t>(first), count, empty);
            }
        };
        static const Framebuffer none;
        const Framebuffer& copy = mark != nullptr ? mark->copy : none;
        put_back(framebuffer_.colour, copy.colour, glm::vec3(0.0f));
        put_back(framebuffer_.depth, copy.depth, framebuffer_.rules.depth_clear);
        put_back(framebuffer_.owner, copy.owner, -1);
        put_back(framebuffer_.overdraw, copy.overdraw, 0u);
    }
}

/// Draws from where the framebuffer stands to the cursor, and lays copies on the way.
void Replay::draw_on(const Cursor& cursor) {
    Mark* last_passed = nullptr;
    for (Mark& mark : marks_) {
        if (mark.cursor > cursor_ && mark.cursor <= cursor && !mark.is_laid()) last_passed = &mark;
    }
    for (Mark& mark : marks_) {
        if (mark.cursor <= cursor_ || mark.cursor > cursor || mark.is_laid()) continue;
        // One a call, the one that lies nearest to where someone is at work.
        const bool is_wanted = mark.on_first_way || (has_gone_back_ && &mark == last_passed);
        if (!is_wanted) continue;
        draw(*frame_, {cursor_, mark.cursor, {}}, framebuffer_);
        cursor_ = mark.cursor;
        mark.copy = framebuffer_;
    }
    draw(*frame_, {cursor_, cursor, {}}, framebuffer_);
    cursor_ = cursor;
}

std::size_t Replay::keyframe_count() const {
    return static_cast<std::size_t>(
        std::count_if(marks_.begin(), marks_.end(), [](const Mark& m) { return m.is_laid(); }));
}

std::size_t Replay::keyframe_bytes() const {
    std::size_t bytes = 0;
    for (const Mark& mark : marks_)
        bytes += mark.copy.bytes();
    return bytes;
}

} // namespace rasterwalk
