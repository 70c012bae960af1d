#include "compare/run_walk.h"

#include <algorithm>
#include <climits>
#include <utility>

#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

/// The most fragments of a run kept at a time.
constexpr int most_kept = 1 << 16;

/// The rows [first, last) of a triangle's row table that lie in the picture.
struct RowRange {
    int first = 0, last = 0;
};

RowRange rows_in_picture(const Frame& frame, int triangle) {
    if (!frame.is_drawn(triangle) || frame.settings.stage < Stage::rows) return {};
    const auto [top, bottom] = table_rows(frame, triangle);
    const int size = bottom - top + 1;
    return {std::clamp(-top, 0, size), std::clamp(frame.settings.viewport.height - top, 0, size)};
}

/// The end of this many box rows in the picture, counted from `begun`; none if there are no more.
std::optional<int> end_of_box_rows(const Frame& frame, int triangle, int begun, int many) {
    if (!frame.is_drawn(triangle) || !tests_pixels(frame.stages)) return std::nullopt;
    TestedPolygon polygon;
    set_up_tests(frame.triangle_vertices(triangle), frame.stages, polygon);
    const Rectangle area = drawn_area(frame);
    int top = 0; // the first row of the triangle's box
    for (const TestedTriangle& tested : polygon.triangles) {
        const Rectangle shown = intersection(tested.box, area);
        const int first = std::max(begun, top + shown.top - tested.box.top);
        const int count = top + shown.bottom - tested.box.top - first;
        if (shown.left < shown.right && count > 0) {
            if (count > many) return first + many;
            many -= count;
        }
        top += tested.box.bottom - tested.box.top;
    }
    return std::nullopt;
}

/// Rows of the table that every part has to make again.
std::int64_t remade_rows(const Frame& frame, int triangle) {
    if (!frame.is_drawn(triangle) || frame.settings.stage < Stage::rows) return 0;
    const auto [top, bottom] = table_rows(frame, triangle);
    return std::int64_t{bottom} - top + 1;
}

Cursor just_after(const Cursor& cursor) {
    Cursor next = cursor;
    ++(phase_info(cursor.phase).step_letter == 0 ? next.index : next.step);
    return next;
}

/// A framebuffer like the picture as far as the work at `cursor` is concerned: the row it touches.
void copy_row(const Frame& frame, const Framebuffer& picture, const Cursor& cursor,
              Framebuffer& copy) {
    if (!(copy.size == picture.size)) clear(copy, picture.size);
    copy.rules = picture.rules;
    // Vertices and edge samples only leave marks, which read nothing.
    if (cursor.phase != Phase::rows) return;
    const int row = table_rows(frame, cursor.triangle).first + cursor.index;
    if (row < 0 || row >= picture.size.height) return;
    const auto first = static_cast<std::ptrdiff_t>(picture.at(0, row));
    const auto copy_plane = [&](const auto& from, auto& into) {
        std::copy_n(from.begin() + first, picture.size.width, into.begin() + first);
    };
    copy_plane(picture.colour, copy.colour);
    copy_plane(picture.depth, copy.depth);
    copy_plane(picture.owner, copy.owner);
    copy_plane(picture.overdraw, copy.overdraw);
}

Observer keep_in(PartEvents& part) {
    Observer observer =
        observe_all([&](const auto& event) { part.others.all.emplace_back(event); });
    observer.pixel_test = [&](const TestEvent& event) { part.tests.all.push_back(event); };
    observer.fragment = [&](const FragmentEvent& event) { part.fragments.all.push_back(event); };
    return observer;
}

void watch_moment(const Frame& frame, const Framebuffer& picture, const Cursor& cursor,
                  Framebuffer& scratch, PartEvents& events) {
    if (cursor.triangle < 0 || cursor.triangle >= frame.triangle_count()) return;
    if (!frame.has_moments(cursor.triangle)) return;
    copy_row(frame, picture, cursor, scratch);
    const Observer keep = keep_in(events);
    draw(frame, {cursor, just_after(cursor), {}}, scratch, &keep);
}

} // namespace

TableRows table_rows(const Frame& frame, int triangle) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    return {box.top, box.bottom - 1};
}

MomentEvents PartEvents::take(const Cursor& cursor) {
    MomentEvents taken;
    for (const Event& event : others.take(cursor)) {
        if (const auto* vertex = std::get_if<VertexEvent>(&event)) taken.vertex = vertex;
        if (const auto* clip = std::get_if<ClipEvent>(&event)) taken.clip = clip;
        if (const auto* cull = std::get_if<CullEvent>(&event)) taken.cull = cull;
        if (const auto* sample = std::get_if<SampleEvent>(&event)) taken.sample = sample;
    }
    for (const TestEvent& test : tests.take(cursor))
        taken.test = &test;
    taken.fragments = fragments.take(cursor);
    return taken;
}

namespace {

/// Reports the moments of both runs in order. False if the visitor has ended the walk.
bool merge(PartEvents& a, PartEvents& b, const PairVisitor& visit) {
    while (true) {
        const Cursor cursor = std::min(a.next(), b.next());
        if (cursor == cursor_end) return true;
        if (!visit({cursor, a.take(cursor), b.take(cursor)})) return false;
    }
}

} // namespace

RunWalk::RunWalk(EventSource a, EventSource b, const Cursor& to)
    : source_a_(std::move(a)), source_b_(std::move(b)), a_(*source_a_.frame), b_(*source_b_.frame),
      to_(to) {}

bool RunWalk::is_done() const {
    return next_.triangle >= a_.triangle_count() || next_ >= to_;
}

void RunWalk::skip_to(int triangle) {
    next_ = std::max(next_, beginning_of(triangle));
}

/// In a box of many pixels, the end of the part that has as many tests as are kept; none if the
/// rest fit in with the first rows. Box rows outside the picture cost nothing, and go with the
/// others.
std::optional<Cursor> RunWalk::part_end_in_box() const {
    if (next_.phase > Phase::tests) return std::nullopt;
    const int begun = next_.phase == Phase::tests ? next_.index : 0;
    const int rows_at_once = std::max(1, most_kept / std::max(1, a_.settings.viewport.width));
    const std::optional<int> of_a = end_of_box_rows(a_, next_.triangle, begun, rows_at_once);
    const std::optional<int> of_b = end_of_box_rows(b_, next_.triangle, begun, rows_at_once);
    if (!of_a && !of_b) return std::nullopt;
    const int end = std::min(of_a.value_or(INT_MAX), of_b.value_or(INT_MAX));
    return Cursor{next_.triangle, Phase::tests, end, 0};
}

/// The end of the part of the triangle that begins at next_: rows with as many fragments as are
/// kept.
Cursor RunWalk::part_end() const {
    if (const std::optional<Cursor> in_box = part_end_in_box()) return *in_box;
    const RowRange rows_a = rows_in_picture(a_, next_.triangle);
    const RowRange rows_b = rows_in_picture(b_, next_.triangle);
    const int last = std::max(rows_a.last, rows_b.last);
    const int rows_at_once = std::max(1, most_kept / std::max(1, a_.settings.viewport.width));
    // Rows above and below the picture cost nothing, and go with the first and the last part.
    int row = next_.index;
    if (next_.phase != Phase::rows) {
        row = last;
        if (rows_a.last > rows_a.first) row = std::min(row, rows_a.first);
        if (rows_b.last > rows_b.first) row = std::min(row, rows_b.first);
    }
    row += rows_at_once;
    return row < last ? Cursor{next_.triangle, Phase::rows, row, 0}
                      : beginning_of(next_.triangle + 1);
}

bool RunWalk::walk_part(const PairVisitor& visit) {
    const Cursor from = next_;
    const bool is_walked = a_.has_moments(from.triangle) || b_.has_moments(from.triangle);
    next_ = is_walked ? part_end() : beginning_of(from.triangle + 1);
    if (!is_walked) return true;
    const Cursor end = std::min(next_, to_);
    const auto play = [&](const EventSource& source, PartEvents& part) {
        part.others.clear();
        part.tests.clear();
        part.fragments.clear();
        source.play({from, end, {}}, keep_in(part));
        work_ += static_cast<std::int64_t>(part.others.all.size() + part.tests.all.size() +
                                           part.fragments.all.size()) +
                 remade_rows(*source.frame, from.triangle);
    };
    play(source_a_, events_a_);
    play(source_b_, events_b_);
    return merge(events_a_, events_b_, visit);
}

void visit_moment(const Frame& a, const Framebuffer& picture_a, const Frame& b,
                  const Framebuffer& picture_b, const Cursor& cursor, Framebuffer& scratch,
                  const PairVisitor& visit) {
    PartEvents of_a, of_b;
    watch_moment(a, picture_a, cursor, scratch, of_a);
    watch_moment(b, picture_b, cursor, scratch, of_b);
    merge(of_a, of_b, visit);
}

} // namespace rasterwalk
