#pragma once

// The one table of the functions that carry out the pipeline. The code that draws and the code that
// shows the drawing both use this table, so a different function in a slot changes both alike. The
// laboratory's mistakes are such functions, in src/mistakes; settings/stage_functions.h says
// which word of which setting puts which of them in the table.

#include "stages/blend.h"
#include "stages/bsp.h"
#include "stages/clip.h"
#include "stages/cull.h"
#include "stages/depth_test.h"
#include "stages/edge_functions.h"
#include "stages/edges.h"
#include "stages/fill_rule.h"
#include "stages/highlight.h"
#include "stages/interpolate.h"
#include "stages/light.h"
#include "stages/light_side.h"
#include "stages/lines.h"
#include "stages/matrices.h"
#include "stages/normal_map.h"
#include "stages/painter.h"
#include "stages/parallax.h"
#include "stages/pixel_shader.h"
#include "stages/polygon_rows.h"
#include "stages/project.h"
#include "stages/put_pixel.h"
#include "stages/reject.h"
#include "stages/samples.h"
#include "stages/shadow.h"
#include "stages/snap.h"
#include "stages/spans.h"
#include "stages/texture_lookup.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// The slots, in the order of the pipeline.
struct Stages {
    decltype(&rasterwalk::vertex_shader) vertex_shader = rasterwalk::vertex_shader;
    decltype(&rasterwalk::to_camera_space) to_camera_space = rasterwalk::to_camera_space;
    decltype(&rasterwalk::rotate_to_camera) rotate_to_camera = rasterwalk::rotate_to_camera;
    decltype(&rasterwalk::to_clip_space) to_clip_space = rasterwalk::to_clip_space;

    // Used by vertex_shader_by_matrices().
    decltype(&rasterwalk::view_matrix) view_matrix = rasterwalk::view_matrix;

    decltype(&reject_nothing) reject = reject_nothing;
    decltype(&clip_nothing) clip = clip_nothing;
    decltype(&cull_nothing) cull = cull_nothing;
    // Called for each fragment, before the depth test.
    decltype(&keep_fragment) cull_fragment = keep_fragment;

    // Project: division, viewport transform and snap.
    decltype(&rasterwalk::project) project = rasterwalk::project;
    decltype(&rasterwalk::is_in_front) is_in_front = rasterwalk::is_in_front;
    decltype(&rasterwalk::perspective_divide) perspective_divide = rasterwalk::perspective_divide;
    decltype(&rasterwalk::viewport_middle) viewport_middle = rasterwalk::viewport_middle;
    decltype(&rasterwalk::snap_to_pixel) snap_to_pixel = rasterwalk::snap_to_pixel;

    // Light, at vertices or at pixels.
    decltype(&rasterwalk::light_normal) light_normal = rasterwalk::light_normal;
    decltype(&rasterwalk::reflected_light) reflected_light = rasterwalk::reflected_light;
    // Called at vertices, and at pixels by surface_shader() alone.
    decltype(&side_of_normal) light_side = side_of_normal;
    // Called for surfaces whose normals differ between corners.
    decltype(&rasterwalk::unit_normal) unit_normal = rasterwalk::unit_normal;
    decltype(&rasterwalk::highlight) highlight = rasterwalk::highlight;
    decltype(&rasterwalk::arrow_of_texel) arrow_of_texel = rasterwalk::arrow_of_texel;
    decltype(&rasterwalk::tangent_frame) tangent_frame = rasterwalk::tangent_frame;
    decltype(&world_space) light_space = world_space;

    // Shadow: how much of the lamp's light arrives, called by surface_light() if something may be
    // in between; the ray to be tested, and the texels of a map that are looked at.
    decltype(&no_shadow) shadow = no_shadow;
    decltype(&rasterwalk::shadow_ray) shadow_ray = rasterwalk::shadow_ray;
    decltype(&nearest_shadow_texel) shadow_texels = nearest_shadow_texel;

    // Coverage: from vertices to rows, and from a row to its fragments. If a replacement can leave
    // the bounding box, replace polygon_box too.
    decltype(&rasterwalk::polygon_box) polygon_box = rasterwalk::polygon_box;
    decltype(&rasterwalk::begin_polygon_rows) begin_polygon_rows = rasterwalk::begin_polygon_rows;
    decltype(&rasterwalk::edge_sample_count) edge_sample_count = rasterwalk::edge_sample_count;
    int (*entered_samples)(int count, bool is_last_edge) = rasterwalk::entered_samples;
    decltype(&rasterwalk::find_row) find_row = rasterwalk::find_row;
    RowEnd (*row_end)(const Fragment& sample) = rasterwalk::row_end;
    decltype(&rasterwalk::compute_polygon_rows) compute_polygon_rows =
        rasterwalk::compute_polygon_rows;
    decltype(&walk_everywhere) walked_area = walk_everywhere;
    int (*row_pixel_count)(int left, int right) = rasterwalk::row_pixel_count;
    int (*drawn_pixels)(int pixel_count) = rasterwalk::drawn_pixels;
    decltype(&rasterwalk::row_fragments) row_fragments = rasterwalk::row_fragments;

    // For coverage that tests pixels at their centres.
    GridPoint (*snap)(const ScreenVertex& vertex) = snap_to_centre;
    bool (*edge_owns_points)(const EdgeDirection& edge) = owns_inclusive;
    decltype(&barycentric_weights) weights = barycentric_weights;
    // Which pixels of a box edge functions test. The picture is the same, the work is not: a
    // function here may leave out only pixels that lie outside.
    decltype(&columns_of_box) tested_columns = columns_of_box;

    // For pixels with more than one sample: where they are, what is tested for depth there, and
    // what becomes of their colours in the end.
    decltype(&rotated_grid) sample_place = rotated_grid;
    decltype(&own_fragment) fragment_at_sample = own_fragment;
    decltype(&mean_of_clamped) resolve = mean_of_clamped;

    // The samples of an edge; the lab's function calls the two slots of Interpolate.
    decltype(&line_by_interpolate) line = line_by_interpolate;

    // Interpolate: along edges and along rows.
    decltype(&rasterwalk::line_step) line_step = rasterwalk::line_step;
    decltype(&rasterwalk::interpolate) interpolate = rasterwalk::interpolate;
    RowEnd (*span_end)(const RowEnd& end) = rasterwalk::span_end;
    decltype(&rasterwalk::varying_weight) varying_weight = rasterwalk::varying_weight;
    // What a fragment divides its varyings by; correctly, the weight that the vertices gave them.
    decltype(&rasterwalk::varying_weight) recovery_weight = rasterwalk::varying_weight;
    MixedWeight mixed_weight; // not a slot: what the function mixed_weight() mixes by

    // Hidden surfaces: by the order in which triangles are drawn, or by depth.
    decltype(&mean_depth) painter_depth = mean_depth;
    decltype(&rasterwalk::is_drawn_before) is_drawn_before = rasterwalk::is_drawn_before;
    decltype(&rasterwalk::is_near_side) is_near_side = rasterwalk::is_near_side;
    decltype(&rasterwalk::depth_test) depth_test = rasterwalk::depth_test;
    decltype(&rasterwalk::depth_cell) depth_cell = rasterwalk::depth_cell;

    // With a pixel shader that reads different varyings, varyings_read must be replaced too.
    decltype(&rasterwalk::pixel_shader) pixel_shader = rasterwalk::pixel_shader;
    VaryingSet (*varyings_read)(Shading shading) = rasterwalk::varyings_read;

    // How far a height map moves the place in the texture, called only where there is one.
    decltype(&step_limited) parallax_step = step_limited;

    // Texture lookup: which level suits a footprint, where a position lies among the texels, which
    // texel is used beyond the border, how it is read, and which texels are mixed.
    decltype(&rasterwalk::texture_level) texture_level = rasterwalk::texture_level;
    decltype(&rasterwalk::texel_place) texel_place = rasterwalk::texel_place;
    decltype(&rasterwalk::read_texel) read_texel = rasterwalk::read_texel;
    int (*wrap_texel)(int texel, int count) = wrap_repeat;
    decltype(&sample_nearest) sample_texture = sample_nearest;

    // Called for each half-transparent fragment, before it is put.
    decltype(&blend_over) blend = blend_over;

    // Put pixel: which pixels there are, and how a channel is encoded.
    decltype(&rasterwalk::drawn_area) drawn_area = rasterwalk::drawn_area;
    ScreenRules screen;

    friend bool operator==(const Stages&, const Stages&) = default;
};

/// Calls the function in a slot. The likeliest ones are called by name, so that the compiler can
/// inline them: a call by pointer takes longer than a depth test.
template <auto likely, auto... others, class... Arguments>
auto call(decltype(likely) slot, const Arguments&... arguments) {
    if (slot == likely) return likely(arguments...);
    if constexpr (sizeof...(others) > 0)
        return call<others...>(slot, arguments...);
    else
        return slot(arguments...);
}

/// row_fragments() with a function that changes the steps of the row: void (LineStep&).
template <auto change_step>
void row_fragments_with(const Stages& stages, const Row& row, int first, VaryingSet carried,
                        std::span<LineSample> result) {
    const LineEnd a = line_end(call<span_end>(stages.span_end, row.left), row.row);
    const LineEnd b = line_end(call<span_end>(stages.span_end, row.right), row.row);
    const LinePart part{row.count, first, Rounding::truncate, carried, false};
    LineStep step = call<line_step>(stages.line_step, a, b, part);
    change_step(step);
    call<interpolate>(stages.interpolate, a, b, step, part, result);
    for (LineSample& sample : result) {
        sample.fragment.column = row.left.column + first++;
        sample.fragment.row = row.row;
    }
}

/// The varyings that edges and rows carry if no texture is shown: those that the pixel shader and
/// the culling of fragments read, and those that are always carried.
VaryingSet carried_varyings(const Stages& stages, Shading shading);

/// Does the pixel have a cell in a depth buffer of the picture's size? Access outside it is
/// guarded: nothing is stored there, and everything is nearer.
inline bool has_depth_cell(const Stages& stages, int column, int row, Viewport picture) {
    const glm::ivec2 cell = stages.depth_cell(column, row);
    return cell.x >= 0 && cell.x < picture.width && cell.y >= 0 && cell.y < picture.height;
}

/// A row of the table as it is drawn.
struct RowSpan {
    int left = 0;  ///< column of its first pixel
    int count = 0; ///< pixels from end to end; the walk along the row has as many samples
    int drawn = 0; ///< of them, from the left
};

/// How the stages draw a row of a table, 0 <= index < rows.size().
RowSpan row_span(const Stages& stages, const PolygonRows& rows, int index);

/// Does coverage walk the edges, sample by sample? If not, it tests pixels at their centres.
bool walks_edges(const Stages& stages);

/// The table with coverage that walks edges: the same, or with the lab's row table in its place.
Stages walking_edges(const Stages& stages);

/// Does coverage test the pixels of a box one by one, so that each test is a moment?
bool tests_pixels(const Stages& stages);

} // namespace rasterwalk
