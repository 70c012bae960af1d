// The pipeline from the polygons on the screen to the picture; prepare_frame() has done the part
// before. For each polygon, in this order:
//
//   show_vertices    stage `points`: a mark for each vertex                     (draw_marks.cpp)
//   notify_clip_and_cull   what has been done to it; leaves no mark       (observe_clipping.cpp)
//   cover            the row table and its tally; stage `edges` shows its samples    (tally.cpp)
//     notify_pixel_tests   which pixels edge functions test; leaves no mark (observe_tests.cpp)
//   show_row_ends    stage `rows`: both ends of each row                        (draw_marks.cpp)
//   fill_rows        for each row, or without an observer all at once       (row_kernel.cpp):
//     interpolate_row    its fragments, from the left to the right end         (fill_rows.cpp)
//     skip_occluded_row   a completely hidden row is only counted, without varyings
//     is_culled          does the fragment belong to a back?
//     fragment_alpha     is its texture clear there? then it is let through
//     test_depth         is the fragment nearer than what its pixel shows?
//     shade              the pixel shader: its colour
//     put_pixel          into the planes; half-transparent colours over what is there
//
// Where pixels have several samples, fill_sample_rows comes in place of fill_rows
// (fill_samples.cpp), and when all polygons are drawn, resolve_pixels makes one colour of the
// samples of each pixel.
//
// If the picture is divided into squares, fill_rows is called for each of them instead, with the
// row table of the one polygon that is drawn in it.

#include "pipeline/draw.h"

#include <algorithm>

#include "pipeline/draw_marks.h"
#include "pipeline/drawing.h"
#include "pipeline/fill_rows.h"
#include "pipeline/fill_samples.h"
#include "pipeline/observe_clipping.h"
#include "pipeline/observe_tests.h"
#include "pipeline/square_steps.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

/// Everything the pixels of a triangle can reach: its box, and a little more.
Rectangle reach_of(const Frame& frame, int triangle) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    // A walk that adds up its steps strays from the box: each addition is off by half a unit in the
    // last place, 2^-24 of the largest value. The bound is twice that; the 1 is for the rounding.
    const int steps = std::max(box.right - box.left, box.bottom - box.top);
    const int largest = std::max({-box.left, box.right, -box.top, box.bottom});
    const int rounding_slack =
        1 + static_cast<int>(0x1p-23f * static_cast<float>(steps) * static_cast<float>(largest));
    return {box.left - rounding_slack, box.top - rounding_slack, box.right + rounding_slack,
            box.bottom + rounding_slack};
}

/// Does the scissor contain a mark that is drawn where clipping has left no corner?
bool has_mark_of_cut(const Drawing& d, int triangle) {
    if (d.frame.settings.stage != Stage::points || !d.frame.is_cut(triangle)) return false;
    for (int v = 0; v < triangle_corners; ++v) {
        const ProjectedVertex& vertex = d.frame.given_vertex(triangle, v);
        const ScreenVertex& pixel = vertex.pixel;
        if (vertex.has_pixel && contains(d.scissor, pixel.column, pixel.row)) return true;
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

Rectangle scissor_rectangle(const DrawWindow& window, const Framebuffer& target) {
    const Rectangle whole{target.origin.x, target.origin.y, target.origin.x + target.size.width,
                          target.origin.y + target.size.height};
    return window.scissor ? intersection(whole, *window.scissor) : whole;
}

/// Coverage: the row table of the triangle.
void cover(Drawing& d, int triangle) {
    EdgeDrawing edges(d, triangle);
    compute_rows(d.frame, triangle, d.rows, edges.is_wanted() ? &edges : nullptr, d.carried);
    if (d.window.from <= beginning_of(triangle)) {
        count_rows(d.frame, d.rows, triangle, d.draws_empty, d.tally);
    }
    notify_pixel_tests(d, triangle);
}

void draw_polygon(Drawing& d, int triangle) {
    const Stage stage = d.frame.settings.stage;
    show_vertices(d, triangle);
    notify_clip_and_cull(d, triangle);
    if (stage == Stage::points || !d.frame.is_drawn(triangle)) return;
    cover(d, triangle);
    if (stage == Stage::rows) show_row_ends(d, triangle);
    if (!has_fragments(stage)) return;
    const auto fill = d.frame.has_samples() ? fill_sample_rows : fill_rows;
    fill(d, d.rows, surface_of(d.frame, triangle), {triangle, Phase::rows, 0, 0});
}

/// Counts the row tables of a frame that is divided into squares, at the first of them.
void count_tables(Drawing& d, bool draws_part) {
    const Cursor first = moment_of_square(0);
    if (d.window.from > first || d.window.to <= first) return;
    for (int t = 0; t < d.frame.triangle_count(); ++t) {
        if (d.frame.is_drawn(t) && (!draws_part || can_reach(d, t)))
            count_rows(d.frame, d.frame.squares->rows(t), t, d.draws_empty, d.tally);
    }
}

void draw_squares(Drawing& d, bool draws_part) {
    count_tables(d, draws_part);
    const WarnockSquares& squares = *d.frame.squares;
    const Rectangle scissor = d.scissor;
    Surface surface;
    int triangle = -1; // that it is of
    for (int n = square_at(squares, d.window.from);
         n < squares.count() && moment_of_square(n) < d.window.to; ++n) {
        const WarnockSquare& square = squares[n];
        d.scissor = intersection(scissor, square.pixels);
        const bool is_meant = d.window.only < 0 || square.surface == d.window.only;
        if (square.surface < 0 || !is_meant || is_empty(d.scissor)) continue;
        if (square.surface != triangle) surface = surface_of(d.frame, square.surface);
        triangle = square.surface;
        fill_rows(d, squares.rows(triangle), surface, {triangle, Phase::rows, 0, 0, 0, n});
    }
}

} // namespace

void clear(Framebuffer& framebuffer, const Frame& frame) {
    clear(framebuffer, frame, frame.settings.viewport, {0, 0});
}

void clear(Framebuffer& framebuffer, const Frame& frame, Viewport size, glm::ivec2 origin) {
    clear(framebuffer, size, origin,
          {depth_clear_rule(frame.settings, frame.scene->space),
           clip_depth_rule(frame.settings, frame.scene->space), frame.stages.depth_cell,
           frame.stages.screen, frame.has_samples()});
}

DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
               const Observer* observer) {
    const Settings& settings = frame.settings;
    const Rectangle scissor = scissor_rectangle(window, framebuffer);
    // An observer sees every varying; without one, only those that the shader reads are walked.
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
              .draws_empty = draws_empty_rows(frame),
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
    const bool draws_part = !(scissor == Rectangle{0, 0, picture.width, picture.height}) &&
                            !(framebuffer.size == Viewport{0, 0});
    const auto begins_in_time = [&](int triangle) {
        return triangle < frame.triangle_count() && beginning_of(triangle) < window.to;
    };
    if (frame.squares != nullptr) {
        draw_squares(d, draws_part);
        return d.tally;
    }
    for (int t = std::max(window.from.triangle, 0); begins_in_time(t); ++t) {
        if (frame.has_moments(t) && (!draws_part || can_reach(d, t))) draw_polygon(d, t);
    }
    if (frame.has_samples()) resolve_pixels(d);
    return d.tally;
}

Framebuffer draw_frame(const Frame& frame) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer);
    return framebuffer;
}

} // namespace rasterwalk
