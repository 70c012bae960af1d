// The pipeline from the polygons on the screen to the picture; what comes before, prepare_frame()
// has done. For each polygon, in this order:
//
//   show_vertices    stage `points`: a mark for each vertex                     (draw_marks.cpp)
//   tell_clip_and_cull   what has been done to it; leaves no mark            (tell_clipping.cpp)
//   cover            the row table; stage `edges` shows the samples that make it
//     tell_pixel_tests   which pixels edge functions ask; leaves no mark       (tell_tests.cpp)
//   show_row_ends    stage `rows`: both ends of each row                        (draw_marks.cpp)
//   fill_rows        for each row:
//     interpolate_row    its fragments, from the left to the right end
//     pass_over_hidden   a row that is hidden altogether is only counted, without varyings
//     is_culled          does the fragment belong to a back?
//     test_depth         is the fragment nearer than what its pixel shows?
//     shade              the pixel shader: its colour
//     put_pixel          into the planes; what is half transparent over what is there

#include "pipeline/draw.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "pipeline/draw_marks.h"
#include "pipeline/drawing.h"
#include "pipeline/surface.h"
#include "pipeline/tell_clipping.h"
#include "pipeline/tell_tests.h"

namespace rasterwalk {

namespace {

Rectangle scissor_rectangle(const DrawWindow& window, const Framebuffer& target) {
    const Rectangle whole{target.origin.x, target.origin.y, target.origin.x + target.size.width,
                          target.origin.y + target.size.height};
    return window.scissor ? intersection(whole, *window.scissor) : whole;
}

/// All that the pixels of a triangle can reach: its box, and a little more.
Rectangle reach_of(const Frame& frame, int triangle) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    // A walk that adds up its steps strays from the box: each addition is off by half a unit in the
    // last place, 2^-24 of the largest value. The bound is twice that; the 1 is for the rounding.
    const int steps = std::max(box.right - box.left, box.bottom - box.top);
    const int largest = std::max({-box.left, box.right, -box.top, box.bottom});
    const int stray =
        1 + static_cast<int>(0x1p-23f * static_cast<float>(steps) * static_cast<float>(largest));
    return {box.left - stray, box.top - stray, box.right + stray, box.bottom + stray};
}

bool is_in(const Rectangle& area, const ScreenVertex& vertex) {
    return vertex.column >= area.left && vertex.column < area.right && vertex.row >= area.top &&
           vertex.row < area.bottom;
}

/// Does a mark lie in the scissor that is put where clipping has left no corner?
bool has_mark_of_cut(const Drawing& d, int triangle) {
    if (d.frame.settings.stage != Stage::points || !d.frame.is_cut(triangle)) return false;
    for (int v = 0; v < triangle_corners; ++v) {
        const ProjectedVertex& vertex = d.frame.given_vertex(triangle, v);
        if (vertex.has_pixel && is_in(d.scissor, vertex.pixel)) return true;
    }
    return false;
}

/// Can a pixel of the triangle lie in the scissor?
bool can_reach(const Drawing& d, int triangle) {
    if (!d.frame.is_drawn(triangle)) return false;
    if (has_mark_of_cut(d, triangle)) return true;
    const Rectangle reach = reach_of(d.frame, triangle);
    return reach.left < d.scissor.right && reach.right > d.scissor.left &&
           reach.top < d.scissor.bottom && reach.bottom > d.scissor.top;
}

DepthResult test_depth(Drawing& d, const Fragment& fragment, std::size_t pixel) {
    return call<depth_test, no_depth_test>(d.stages.depth_test, fragment, d.target.depth[pixel],
                                           d.depth);
}

glm::vec3 shade(Drawing& d, const Fragment& fragment, const Surface& surface) {
    ++d.tally.shaded;
    return d.stages.pixel_shader(fragment, surface, d.pixels, d.stages);
}

/// Has the fragment's pixel a place in the depth buffer? Counts those tested without.
bool has_cell(Drawing& d, const Fragment& fragment) {
    const bool has_one = d.all_have_cells || has_depth_cell(d.stages, fragment.column, fragment.row,
                                                            d.frame.settings.viewport);
    if (!has_one && d.is_depth_tested) ++d.tally.depth_outside;
    return has_one;
}

void put_pixel(Drawing& d, std::size_t pixel, int triangle, const glm::vec3& colour, float alpha) {
    d.target.colour[pixel] =
        alpha < 1.0f ? d.stages.blend(colour, alpha, d.target.colour[pixel]) : colour;
    d.target.owner[pixel] = triangle;
}

bool is_culled(const Drawing& d, const Fragment& fragment) {
    return d.culls_fragments && d.stages.cull_fragment(fragment, d.rays, d.stages);
}

/// Cull, depth test, pixel shader, put pixel.
/// @param pixel where the fragment stands in the planes
template <bool is_watched>
void draw_fragment(Drawing& d, const Cursor& cursor, const Fragment& fragment, std::size_t pixel,
                   const Surface& surface) {
    const float stored = d.target.depth[pixel];
    const glm::vec3 before = d.target.colour[pixel];
    if (is_culled(d, fragment)) {
        ++d.target.overdraw[pixel];
        if constexpr (is_watched)
            d.observer->fragment(
                {cursor, fragment, Fate::back_facing, fragment.depth, stored, before, before});
        return;
    }
    glm::vec3 colour(0.0f);
    if (d.shades_first) colour = shade(d, fragment, surface);
    const bool is_stored = has_cell(d, fragment);
    const DepthResult test = test_depth(d, fragment, pixel);
    ++d.target.overdraw[pixel];
    if (test.passed) {
        if (!d.shades_first) colour = shade(d, fragment, surface);
        if (is_stored) d.target.depth[pixel] = test.depth;
        put_pixel(d, pixel, cursor.triangle, colour, surface.alpha);
    }
    if constexpr (is_watched) {
        const Fate fate = test.passed ? Fate::written : Fate::depth_failed;
        d.observer->fragment(
            {cursor, fragment, fate, test.depth, stored, before, d.target.colour[pixel]});
    }
}

/// The fragments of a row, side by side; all must lie in the scissor.
template <bool is_watched>
void draw_fragments(Drawing& d, Cursor cursor, std::span<const LineSample> fragments,
                    const Surface& surface) {
    const Fragment& first = fragments.front().fragment;
    std::size_t pixel = d.target.at(first.column, first.row);
    d.tally.fragments += static_cast<std::int64_t>(fragments.size());
    for (const LineSample& sample : fragments) {
        draw_fragment<is_watched>(d, cursor, sample.fragment, pixel, surface);
        ++cursor.step;
        ++pixel;
    }
}

/// Fragments of a triangle's table that are walked and fall beside what the bounds test lets
/// through.
std::int64_t count_outside(const Frame& frame, int triangle, const PolygonRows& rows) {
    const Rectangle area = drawn_area(frame);
    const Rectangle walked = frame.stages.walked_area(frame.settings.viewport);
    const Rectangle reach = intersection(reach_of(frame, triangle), walked);
    if (reach.left >= area.left && reach.right <= area.right && reach.top >= area.top &&
        reach.bottom <= area.bottom)
        return 0;
    std::int64_t outside = 0;
    for (int r = 0; r < rows.size(); ++r) {
        const RowSpan span = row_span(frame.stages, rows, r);
        if (span.drawn <= 0 || rows.is_empty_row(r)) continue;
        const int row = rows.first_row + r;
        const std::int64_t left = std::max(span.left, walked.left);
        const std::int64_t behind =
            std::min<std::int64_t>(std::int64_t{span.left} + span.drawn, walked.right);
        if (row < walked.top || row >= walked.bottom || left >= behind) continue;
        const bool is_in_picture = row >= area.top && row < area.bottom;
        const std::int64_t inside = is_in_picture ? std::min<std::int64_t>(behind, area.right) -
                                                        std::max<std::int64_t>(left, area.left)
                                                  : 0;
        outside += behind - left - std::max<std::int64_t>(inside, 0);
    }
    return outside;
}

/// What the row table took, and what is wrong with it.
void count_rows(const Frame& frame, const PolygonRows& rows, int triangle, bool draws_unset,
                DrawTally& tally) {
    if (has_fragments(frame.settings.stage))
        tally.fragments_outside += count_outside(frame, triangle, rows);
    tally.samples_outside += rows.outside;
    tally.triangles_outside += rows.outside > 0 ? 1 : 0;
    if (rows.outside > 0 && tally.first_outside < 0) tally.first_outside = triangle;
    tally.rows_looked_at += rows.looked_at;
    tally.pixels_tested += count_pixel_tests(frame, rows.tested);
    if (!draws_unset) return;
    for (int r = 0; r < rows.size(); ++r)
        tally.unset_rows += rows.is_empty_row(r) ? 1 : 0;
}

/// Are rows that no edge sample has reached drawn all the same?
bool draws_unset_rows(const Frame& frame) {
    return has_fragments(frame.settings.stage) &&
           frame.stages.row_pixel_count(empty_left, empty_right) != 0;
}

/// Coverage: the row table of the triangle.
void cover(Drawing& d, int triangle) {
    EdgeDrawing edges(d, triangle);
    compute_rows(d.frame, triangle, d.rows, edges.is_wanted() ? &edges : nullptr, d.carried);
    if (d.window.from <= Cursor{triangle, Phase::vertices, 0, 0}) {
        count_rows(d.frame, d.rows, triangle, d.draws_unset, d.tally);
    }
    tell_pixel_tests(d, triangle);
}

/// The columns of a row that lie in the window and in the scissor, counted from its left end.
PieceRange columns_in_window(const Drawing& d, const Cursor& row, const RowSpan& span) {
    if (span.drawn <= 0) return {0, 0};
    const PieceRange columns = clamp_to_window(d.window, row, &Cursor::step, span.drawn);
    // In 64 bits: a row that no sample has reached begins at INT_MAX.
    const std::int64_t left = span.left;
    const std::int64_t first = std::max<std::int64_t>(columns.first, d.scissor.left - left);
    const std::int64_t last = std::min<std::int64_t>(columns.last, d.scissor.right - left);
    if (first >= last) return {0, 0};
    return {static_cast<int>(first), static_cast<int>(last)};
}

/// The fragments of a row of the table that stand in these of its columns.
std::span<const LineSample> interpolate_row(Drawing& d, int index, const RowSpan& span,
                                            const PieceRange& columns, VaryingSet carried) {
    const auto i = static_cast<std::size_t>(index);
    const Row row{d.rows.left[i], d.rows.right[i], d.rows.first_row + index, span.count,
                  &d.rows.tested};
    const std::span<LineSample> fragments = samples_of(d.fragments, columns.last - columns.first);
    call<row_fragments, fragments_by_weights>(d.stages.row_fragments, d.stages, row, columns.first,
                                              carried, fragments);
    return fragments;
}

/// Counts the fragments of a row if none of them is nearer than what its pixel shows; tells whether
/// it did.
bool pass_over_hidden(Drawing& d, std::span<const LineSample> fragments) {
    const Fragment& first = fragments.front().fragment;
    const std::size_t begin = d.target.at(first.column, first.row);
    std::size_t pixel = begin;
    for (const LineSample& sample : fragments) {
        if (depth_test(sample.fragment, d.target.depth[pixel++], d.depth).passed) return false;
    }
    d.tally.fragments += static_cast<std::int64_t>(fragments.size());
    for (pixel = begin; pixel < begin + fragments.size(); ++pixel)
        ++d.target.overdraw[pixel];
    return true;
}

/// The same by the kernel.
void draw_row_at_once(Drawing& d, int triangle, int index, const RowSpan& span,
                      const PieceRange& columns, const Surface& surface) {
    const auto i = static_cast<std::size_t>(index);
    const RowPart part{.left = d.rows.left[i],
                       .right = d.rows.right[i],
                       .count = span.count,
                       .first = columns.first,
                       .drawn = columns.last - columns.first,
                       .pixel = d.target.at(span.left + columns.first, d.rows.first_row + index),
                       .triangle = triangle};
    d.tally.fragments += part.drawn;
    d.tally.shaded += d.row_kernel(part, {surface, d.pixels, d.stages}, d.target);
}

/// The lab's DrawPolygonRows: every row from its left to its right end, both included.
void fill_rows(Drawing& d, int triangle) {
    const PolygonRows& rows = d.rows;
    const Surface surface = surface_of(d.frame, triangle);
    const PieceRange range =
        clamp_to_window(d.window, {triangle, Phase::rows, 0, 0}, &Cursor::index, rows.size());
    // The row above the first that begins in the window may end in it; its columns will tell.
    const int first_row = std::max({range.first - 1, d.scissor.top - rows.first_row, 0});
    const int last_row = std::min(range.last, d.scissor.bottom - rows.first_row);
    for (int r = first_row; r < last_row; ++r) {
        const RowSpan span = row_span(d.stages, rows, r);
        const PieceRange columns = columns_in_window(d, {triangle, Phase::rows, r, 0}, span);
        if (columns.first >= columns.last) continue;
        if (d.row_kernel != nullptr) {
            draw_row_at_once(d, triangle, r, span, columns, surface);
            continue;
        }
        if (d.skips_hidden && pass_over_hidden(d, interpolate_row(d, r, span, columns, {})))
            continue;
        const std::span<const LineSample> fragments =
            interpolate_row(d, r, span, columns, d.carried);
        const Cursor cursor{triangle, Phase::rows, r, columns.first};
        if (d.observer == nullptr)
            draw_fragments<false>(d, cursor, fragments, surface);
        else
            draw_fragments<true>(d, cursor, fragments, surface);
    }
}

void draw_polygon(Drawing& d, int triangle) {
    const Stage stage = d.frame.settings.stage;
    show_vertices(d, triangle);
    tell_clip_and_cull(d, triangle);
    if (stage == Stage::points || !d.frame.is_drawn(triangle)) return;
    cover(d, triangle);
    if (stage == Stage::rows) show_row_ends(d, triangle);
    if (has_fragments(stage)) fill_rows(d, triangle);
}

} // namespace

DrawTally& operator+=(DrawTally& sum, const DrawTally& part) {
    sum.fragments += part.fragments;
    sum.fragments_outside += part.fragments_outside;
    sum.samples_outside += part.samples_outside;
    sum.triangles_outside += part.triangles_outside;
    const bool is_earlier = sum.first_outside < 0 || part.first_outside < sum.first_outside;
    if (part.first_outside >= 0 && is_earlier) sum.first_outside = part.first_outside;
    sum.shaded += part.shaded;
    sum.rows_looked_at += part.rows_looked_at;
    sum.pixels_tested += part.pixels_tested;
    sum.unset_rows += part.unset_rows;
    sum.depth_outside += part.depth_outside;
    return sum;
}

DrawTally tally_rows(const Frame& frame, int first) {
    DrawTally tally;
    if (frame.settings.stage == Stage::points) return tally;
    const bool draws_unset = draws_unset_rows(frame);
    PolygonRows rows;
    for (int t = std::max(first, 0); t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        compute_rows(frame, t, rows, nullptr, {});
        count_rows(frame, rows, t, draws_unset, tally);
    }
    return tally;
}

void clear(Framebuffer& framebuffer, const Frame& frame) {
    clear(framebuffer, frame, frame.settings.viewport, {0, 0});
}

void clear(Framebuffer& framebuffer, const Frame& frame, Viewport size, glm::ivec2 origin) {
    clear(framebuffer, size, origin,
          {depth_clear_rule(frame.settings, frame.scene->space),
           clip_depth_rule(frame.settings, frame.scene->space), frame.stages.depth_cell,
           frame.stages.to_byte, frame.stages.visible_channel});
}

DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               Observer* observer) {
    const Settings& settings = frame.settings;
    const Rectangle scissor = scissor_rectangle(window, framebuffer);
    // Whoever watches sees every varying; otherwise only those are walked that the shader reads.
    const VaryingSet carried = observer != nullptr ? VaryingSet::all() : carried_varyings(frame);
    Drawing d{.frame = frame,
              .stages = frame.stages,
              .window = window,
              .scissor = intersection(scissor, drawn_area(frame)),
              .pixels = pixel_rules(frame),
              .rays = sight_rays(vertex_rules(settings, frame.scene->space)),
              .carried = carried,
              .depth = depth_rules(settings, frame.scene->space),
              .is_depth_tested = depth_rule(settings) != DepthTest::off,
              .all_have_cells = frame.stages.depth_cell == depth_cell,
              .culls_fragments = frame.stages.cull_fragment != keep_fragment,
              .shades_first = settings.depth_order == DepthOrder::before_depth_test,
              .draws_unset = draws_unset_rows(frame),
              .skips_hidden = observer == nullptr && !(carried == VaryingSet{}) &&
                              frame.stages.depth_test == depth_test &&
                              frame.stages.depth_cell == depth_cell &&
                              settings.depth_order == DepthOrder::after_depth_test,
              .row_kernel = observer == nullptr ? row_kernel_of(frame) : nullptr,
              .target = framebuffer,
              .observer = observer,
              .rows = {},
              .fragments = {},
              .tally = {}};
    const Viewport picture = settings.viewport;
    const bool draws_part = !(scissor == Rectangle{0, 0, picture.width, picture.height});
    const int count = frame.triangle_count();
    const int last = std::min(window.to.triangle, count - 1);
    for (int t = std::max(window.from.triangle, 0); t <= last; ++t) {
        if (frame.has_moments(t) && (!draws_part || can_reach(d, t))) draw_polygon(d, t);
    }
    return d.tally;
}

Framebuffer draw_frame(const Frame& frame) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer);
    return framebuffer;
}

} // namespace rasterwalk
