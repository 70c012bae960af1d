#include "pipeline/draw_marks.h"

#include <algorithm>

namespace rasterwalk {

namespace {

constexpr glm::vec3 white{1.0f};

/// Points, edges and row ends are marks: one colour, no depth.
/// @param told gives the fragment for an observer
template <class MakeFragment>
void put_mark(Drawing& d, const Cursor& cursor, glm::ivec2 place, const glm::vec3& colour,
              MakeFragment make_fragment) {
    if (!contains(d.scissor, place.x, place.y)) return;
    const std::size_t pixel = d.target.at(place.x, place.y);
    const float depth = d.target.rules.depth_clear, stored = d.target.depth[pixel];
    const glm::vec3 before = d.target.colour[pixel];
    ++d.tally.fragments;
    ++d.target.overdraw[pixel];
    d.target.colour[pixel] = colour;
    d.target.depth[pixel] = depth;
    d.target.owner[pixel] = cursor.triangle;
    if (d.observer == nullptr || !d.observer->fragment) return;
    d.observer->fragment({cursor, make_fragment(), Fate::written, depth, stored, before, colour});
}

void show_row_end(Drawing& d, const Cursor& cursor, const RowEnd& end, const glm::vec3& colour) {
    const int row = d.rows.first_row + cursor.index;
    put_mark(d, cursor, {end.column, row}, colour, [&] { return mark_of(end, row); });
}

} // namespace

void show_vertices(Drawing& d, int triangle) {
    const bool is_shown = d.frame.settings.stage == Stage::points && d.frame.is_drawn(triangle);
    if (!is_shown && d.observer == nullptr) return;
    const PieceRange range = clamp_to_window(d.window, {triangle, Phase::vertices, 0, 0},
                                             &Cursor::index, triangle_corners);
    for (int v = range.first; v < range.last; ++v) {
        const Cursor cursor{triangle, Phase::vertices, v, 0};
        const ProjectedVertex& vertex = d.frame.given_vertex(triangle, v);
        if (d.observer != nullptr && d.observer->vertex)
            d.observer->vertex({cursor, vertex, d.frame.given_clip_vertex(triangle, v).varyings});
        if (!is_shown || !vertex.has_pixel) continue;
        put_mark(d, cursor, {vertex.pixel.column, vertex.pixel.row}, white,
                 [&] { return mark_of(vertex.pixel); });
    }
}

EdgeDrawing::EdgeDrawing(Drawing& drawing, int triangle)
    : d_(drawing), triangle_(triangle), shown_(d_.frame.settings.stage == Stage::edges),
      watched_(d_.observer != nullptr && d_.observer->edge_sample != nullptr) {}

bool EdgeDrawing::is_wanted() const {
    return (shown_ || watched_) && d_.window.from < Cursor{triangle_, Phase::rows, 0, 0} &&
           d_.window.to > Cursor{triangle_, Phase::edges, 0, 0};
}

void EdgeDrawing::edge_sample(const EdgeSample& sample) {
    const Cursor cursor{triangle_, Phase::edges, sample.edge, sample.sample};
    if (cursor < d_.window.from || cursor >= d_.window.to) return;
    if (watched_) d_.observer->edge_sample({cursor, sample});
    if (!shown_) return;
    put_mark(d_, cursor, {sample.fragment.column, sample.fragment.row}, white,
             [&] { return sample.fragment; });
}

void show_row_ends(Drawing& d, int triangle) {
    const PieceRange range =
        clamp_to_window(d.window, {triangle, Phase::rows, 0, 0}, &Cursor::index, d.rows.size());
    const int first = std::max(range.first, d.scissor.top - d.rows.first_row);
    const int last = std::min(range.last, d.scissor.bottom - d.rows.first_row);
    for (int r = first; r < last; ++r) {
        if (d.rows.is_empty_row(r)) continue;
        const Cursor cursor{triangle, Phase::rows, r, 0};
        show_row_end(d, cursor, d.rows.left[r], left_end_colour);
        show_row_end(d, cursor, d.rows.right[r], right_end_colour);
    }
}

} // namespace rasterwalk
