#include "settings/choose_stages.h"

#include "mistakes/blend.h"
#include "mistakes/clip.h"
#include "mistakes/coverage.h"
#include "mistakes/cull.h"
#include "mistakes/depth_test.h"
#include "mistakes/highlight.h"
#include "mistakes/interpolate.h"
#include "mistakes/light.h"
#include "mistakes/lines.h"
#include "mistakes/normal_map.h"
#include "mistakes/project.h"
#include "mistakes/put_pixel.h"
#include "mistakes/shadow.h"
#include "mistakes/texture.h"
#include "mistakes/vertex_shader.h"
#include "stages/active_edges.h"
#include "stages/matrices.h"
#include "stages/orthographic.h"
#include "stages/scan_conversion.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

namespace {

void choose(Rotation rotation, Stages& stages) {
    if (rotation == Rotation::transposed) stages.rotate_to_camera = rotate_transposed;
}

void choose(CameraMove move, Stages& stages) {
    switch (move) {
    case CameraMove::subtracted:
        break;
    case CameraMove::added:
        stages.to_camera_space = to_camera_by_adding;
        break;
    case CameraMove::rotated_first:
        stages.to_camera_space = to_camera_rotated_first;
        break;
    }
}

using ClipSpaceFunction = decltype(Stages::to_clip_space);

template <auto project>
ClipSpaceFunction projection_with(ImageAxes axes) {
    switch (axes) {
    case ImageAxes::right_way:
    case ImageAxes::uncentred:
        break;
    case ImageAxes::mirrored:
        return to_clip_space_with<axes_mirrored, project>;
    case ImageAxes::exchanged:
        return to_clip_space_with<axes_exchanged, project>;
    }
    return project;
}

void choose(ImageAxes axes, DividedBy divided_by, ClipDepth depth, Stages& stages) {
    // Only perspective with 1/z is the lab's.
    const bool is_lab = depth == ClipDepth::inv_z, is_by_z = divided_by == DividedBy::z;
    if (is_by_z && is_lab)
        stages.to_clip_space = projection_with<to_clip_space>(axes);
    else if (is_by_z)
        stages.to_clip_space = projection_with<to_clip_space_mixed>(axes);
    else if (is_lab)
        stages.to_clip_space = projection_with<to_clip_space_by_distance<to_clip_space>>(axes);
    else
        stages.to_clip_space =
            projection_with<to_clip_space_by_distance<to_clip_space_mixed>>(axes);
    if (axes == ImageAxes::uncentred) stages.viewport_middle = middle_in_corner;
}

using VertexShaderFunction = decltype(Stages::vertex_shader);

template <bool is_transposed>
VertexShaderFunction matrices_with(ImageAxes axes) {
    switch (axes) {
    case ImageAxes::right_way:
    case ImageAxes::uncentred:
        break;
    case ImageAxes::mirrored:
        return mistaken_matrices<is_transposed, axes_mirrored>;
    case ImageAxes::exchanged:
        return mistaken_matrices<is_transposed, axes_exchanged>;
    }
    if constexpr (is_transposed)
        return mistaken_matrices<true, axes_kept>;
    else
        return vertex_shader_by_matrices;
}

void choose(Transform transform, Rotation rotation, ImageAxes axes, Stages& stages) {
    if (transform == Transform::lab) return;
    stages.vertex_shader =
        rotation == Rotation::row_vector ? matrices_with<false>(axes) : matrices_with<true>(axes);
}

void choose(Transform transform, Translation translation, Stages& stages) {
    if (transform == Transform::matrices && translation == Translation::bottom_row)
        stages.view_matrix = view_matrix_with_bottom_row;
}

void choose(NormalW w, Stages& stages) {
    if (w == NormalW::one) stages.light_normal = light_normal_as_place;
}

void choose(Reject reject, Stages& stages) {
    if (reject == Reject::none) return;
    stages.reject = reject_by_outcodes;
    if (reject == Reject::cheap) stages.walked_area = walk_in_picture;
}

void choose(Clip clip, Stages& stages) {
    switch (clip) {
    case Clip::leave_out:
        break;
    case Clip::none:
        stages.is_in_front = is_in_front_unasked;
        break;
    case Clip::near:
        stages.clip = clip_near;
        stages.is_in_front = has_positive_w;
        break;
    case Clip::all:
        stages.clip = clip_all;
        stages.is_in_front = has_positive_w;
        break;
    case Clip::guard_band:
        stages.clip = clip_guard_band;
        stages.is_in_front = has_positive_w;
        break;
    case Clip::whole_only:
        stages.clip = drop_partly_outside;
        break;
    case Clip::wrong_t:
        stages.clip = clip_near_with_wrong_t;
        break;
    case Clip::after_division:
        stages.clip = clip_after_division;
        stages.is_in_front = is_in_front_unasked;
        break;
    case Clip::clamped:
        stages.clip = move_to_near_plane;
        break;
    case Clip::uncut_varyings:
        stages.clip = clip_near_with_uncut_varyings;
        break;
    }
}

void choose(Cull cull, Stages& stages) {
    switch (cull) {
    case Cull::none:
        break;
    case Cull::face_normal:
        stages.cull = cull_by_face_normal;
        break;
    case Cull::screen_area:
        stages.cull = cull_by_screen_area;
        break;
    case Cull::vertex_normals:
        stages.cull = cull_by_vertex_normals;
        break;
    case Cull::fragment_normal:
        stages.cull_fragment = cull_by_fragment_normal;
        break;
    case Cull::view_axis:
        stages.cull = cull_by_view_axis;
        break;
    case Cull::lamp:
        stages.cull = cull_by_lamp;
        break;
    }
}

void choose(BehindMark mark, Stages& stages) {
    if (mark == BehindMark::minus_one) stages.project = project_marking_column;
}

void choose(OutsidePicture outside, Stages& stages) {
    if (outside == OutsidePicture::clamped) stages.snap_to_pixel = snap_into_picture;
}

void choose(LineWalk walk, Stages& stages) {
    switch (walk) {
    case LineWalk::accumulate:
        break;
    case LineWalk::multiply:
        stages.interpolate = interpolate_by_multiplying;
        break;
    case LineWalk::exact:
        stages.interpolate = interpolate_exactly;
        break;
    case LineWalk::integer_step:
        stages.line_step = line_step_of_integers;
        break;
    case LineWalk::short_step:
        stages.line_step = line_step_by_samples;
        break;
    case LineWalk::zinv_falls:
        stages.row_fragments = row_fragments_with_falling_zinv;
        break;
    }
}

void choose(EdgeSamples samples, Stages& stages) {
    switch (samples) {
    case EdgeSamples::longest_axis:
        break;
    case EdgeSamples::rows:
        stages.edge_sample_count = edge_sample_count_by_rows;
        break;
    case EdgeSamples::shifted:
        stages.edge_sample_count = edge_sample_count_shifted;
        break;
    case EdgeSamples::without_last:
        stages.entered_samples = entered_without_last;
        break;
    case EdgeSamples::no_last_edge:
        stages.entered_samples = entered_without_last_edge;
        break;
    }
}

void choose(BresenhamRule rule, Stages& stages) {
    switch (rule) {
    case BresenhamRule::right:
        stages.line = line_by_bresenham;
        break;
    case BresenhamRule::first_octant:
        stages.line = line_in_first_octant;
        stages.edge_sample_count = edge_sample_count_to_the_right;
        break;
    case BresenhamRule::wrong_term:
        stages.line = line_by_wrong_term;
        break;
    }
}

/// Only Interpolate allows a different number of samples.
void choose(LineAlgorithm line, const Settings& settings, Stages& stages) {
    switch (line) {
    case LineAlgorithm::interpolate:
        choose(settings.edge_samples, stages);
        break;
    case LineAlgorithm::bresenham:
        choose(settings.bresenham_rule, stages);
        break;
    case LineAlgorithm::midpoint:
        stages.line = line_by_midpoint;
        break;
    case LineAlgorithm::dda:
        stages.line = line_by_dda;
        break;
    }
}

void choose(FillRule rule, Stages& stages) {
    switch (rule) {
    case FillRule::inclusive:
        break;
    case FillRule::exclusive:
        stages.edge_owns_points = owns_exclusive;
        break;
    case FillRule::top_left:
        stages.edge_owns_points = owns_top_left;
        break;
    case FillRule::left_only:
        stages.edge_owns_points = owns_left_only;
        break;
    }
}

void choose(Snap snap, PixelSample sample, Stages& stages) {
    const bool at_centre = sample == PixelSample::centre;
    switch (snap) {
    case Snap::pixel:
        stages.snap = at_centre ? snap_to_centre : snap_for_corners<snap_to_centre>;
        break;
    case Snap::sixteenth:
        stages.snap = at_centre ? snap_to_sixteenth : snap_for_corners<snap_to_sixteenth>;
        break;
    case Snap::subpixel:
        stages.snap = at_centre ? snap_to_subpixel : snap_for_corners<snap_to_subpixel>;
        break;
    }
}

void choose(RowStart start, Stages& stages) {
    switch (start) {
    case RowStart::extreme:
        break;
    case RowStart::window:
        stages.begin_polygon_rows = begin_rows_at_picture;
        stages.polygon_box = polygon_box_at_picture;
        break;
    case RowStart::row_short:
        stages.begin_polygon_rows = begin_rows_without_last;
        break;
    }
}

void choose(RowSearch search, Stages& stages) {
    switch (search) {
    case RowSearch::indexed:
        break;
    case RowSearch::all_rows:
        stages.find_row = find_row_among_all;
        break;
    case RowSearch::clamped:
        stages.find_row = find_nearest_row;
        break;
    case RowSearch::column_only:
        stages.row_end = row_end_of_column;
        break;
    }
}

void choose(EmptyRows rows, Stages& stages) {
    if (rows == EmptyRows::overflow) stages.row_pixel_count = row_pixel_count_wrapped;
}

void choose(Spans spans, Stages& stages) {
    switch (spans) {
    case Spans::inclusive:
        break;
    case Spans::single_skipped:
        stages.drawn_pixels = drawn_pixels_without_single;
        break;
    case Spans::last_dropped:
        stages.drawn_pixels = drawn_pixels_without_last;
        break;
    }
}

/// Only a row table filled by edge samples can go wrong in some ways.
void choose_coverage(const Settings& settings, Stages& stages) {
    const Coverage coverage = coverage_rule(settings);
    if (coverage == Coverage::rows) {
        choose(settings.row_start, stages);
        choose(settings.row_search, stages);
        choose(settings.empty_rows, stages);
        choose(settings.spans, stages);
        return;
    }
    choose(settings.fill_rule, stages);
    choose(settings.snap, settings.pixel_sample, stages);
    stages.polygon_box = snapped_box;
    stages.compute_polygon_rows = coverage == Coverage::edge_functions    ? rows_by_edge_functions
                                  : coverage == Coverage::scan_conversion ? rows_by_scan_conversion
                                                                          : rows_by_active_edges;
    if (coverage != Coverage::edge_functions) return;
    stages.row_fragments = fragments_by_weights;
    if (settings.box_walk == BoxWalk::interval) stages.tested_columns = columns_between_crossings;
    if (settings.weight_edge == WeightEdge::own) stages.weights = weights_of_own_edges;
}

void choose(Interpolation interpolation, Stages& stages) {
    switch (interpolation) {
    case Interpolation::perspective:
        break;
    case Interpolation::affine:
        stages.varying_weight = varying_weight_one;
        stages.recovery_weight = varying_weight_one;
        break;
    case Interpolation::zinv_twice:
        stages.span_end = span_end_times_zinv;
        break;
    case Interpolation::undivided:
        stages.recovery_weight = varying_weight_one;
        break;
    case Interpolation::divided_twice:
        stages.recovery_weight = recovery_weight_squared;
        break;
    }
}

void choose(TextureFilter filter, Stages& stages) {
    switch (filter) {
    case TextureFilter::nearest:
        break;
    case TextureFilter::bilinear:
        stages.sample_texture = sample_bilinear;
        break;
    case TextureFilter::mipmap:
        stages.sample_texture = sample_mipmap;
        break;
    case TextureFilter::trilinear:
        stages.sample_texture = sample_trilinear;
        break;
    }
}

void choose(TextureWrap wrap, Stages& stages) {
    switch (wrap) {
    case TextureWrap::repeat:
        break;
    case TextureWrap::clamp:
        stages.wrap_texel = wrap_clamp;
        break;
    case TextureWrap::mirror:
        stages.wrap_texel = wrap_mirror;
        break;
    }
}

void choose(TexelRule rule, TextureWrap wrap, Stages& stages) {
    switch (rule) {
    case TexelRule::right:
        break;
    case TexelRule::upside_down:
        stages.texel_place = texel_place_upside_down;
        break;
    case TexelRule::whole_centres:
        stages.texel_place = texel_place_of_whole_centres;
        break;
    case TexelRule::remainder:
        if (wrap != TextureWrap::repeat) break;
        stages.wrap_texel = wrap_by_remainder;
        stages.read_texel = read_texel_in_memory;
        break;
    case TexelRule::level_along_x:
        stages.texture_level = texture_level_along_x;
        break;
    }
}

void choose(NormalMapRule rule, Stages& stages) {
    switch (rule) {
    case NormalMapRule::right:
        break;
    case NormalMapRule::green_turned:
        stages.arrow_of_texel = arrow_with_green_turned;
        break;
    case NormalMapRule::mirror_missed:
        stages.tangent_frame = tangent_frame_unasked;
        break;
    case NormalMapRule::undecoded:
        stages.arrow_of_texel = arrow_undecoded;
        break;
    }
}

void choose(NormalMapSpace space, Stages& stages) {
    if (space == NormalMapSpace::tangent) stages.light_space = tangent_space;
}

using LightFunction = decltype(Stages::reflected_light);

template <auto way, auto square, auto length, auto area>
LightFunction light_with(LightSum sum) {
    switch (sum) {
    case LightSum::reflectance_times:
        break;
    case LightSum::reflectance_plus:
        return mistaken_light<way, square, length, area, reflectance_plus>;
    case LightSum::reflectance_twice:
        return mistaken_light<way, square, length, area, reflectance_twice>;
    }
    return mistaken_light<way, square, length, area, reflectance_times>;
}

template <auto way, auto square, auto length>
LightFunction light_with(const LightRules& rules) {
    switch (rules.falloff) {
    case LightFalloff::sphere:
        break;
    case LightFalloff::no_4pi:
        return light_with<way, square, length, area_without_4pi>(rules.sum);
    case LightFalloff::linear:
        return light_with<way, square, length, area_of_distance>(rules.sum);
    case LightFalloff::none:
        return light_with<way, square, length, area_of_one>(rules.sum);
    case LightFalloff::cubed:
        return light_with<way, square, length, cubed_area>(rules.sum);
    case LightFalloff::pi_of_atan:
        return light_with<way, square, length, area_with_pi_of_atan>(rules.sum);
    case LightFalloff::pi_three:
        return light_with<way, square, length, area_with_pi_three>(rules.sum);
    }
    return light_with<way, square, length, sphere_area>(rules.sum);
}

void choose(HighlightRule rule, Stages& stages) {
    switch (rule) {
    case HighlightRule::right:
        break;
    case HighlightRule::unasked:
        stages.highlight = highlight_unasked;
        break;
    case HighlightRule::long_half:
        stages.highlight = highlight_with_long_half;
        break;
    }
}

void choose(const LightRules& rules, Stages& stages) {
    choose(rules.highlight, stages);
    if (rules.renormalize == Renormalize::off) stages.unit_normal = normal_as_interpolated;
    if (rules.sides == LightSides::two) stages.light_side = side_of_eye;
    const LightRules lab;
    if (rules.direction == lab.direction && rules.falloff == lab.falloff && rules.sum == lab.sum)
        return;
    switch (rules.direction) {
    case LightDirection::to_light:
        stages.reflected_light = light_with<way_to_lamp, own_square, own_length>(rules);
        break;
    case LightDirection::from_light:
        stages.reflected_light = light_with<way_from_lamp, own_square, own_length>(rules);
        break;
    case LightDirection::not_normalized:
        stages.reflected_light = light_with<way_to_lamp, own_square, not_normalized>(rules);
        break;
    case LightDirection::with_w:
        stages.reflected_light = light_with<way_to_lamp, square_with_w, own_length>(rules);
        break;
    }
}

void choose(Shadows shadows, Stages& stages) {
    switch (shadows) {
    case Shadows::off:
        break;
    case Shadows::rays:
        stages.shadow = shadow_by_ray;
        break;
    case Shadows::map:
        stages.shadow = shadow_by_map;
        break;
    }
}

void choose(ShadowRay ray, Stages& stages) {
    if (ray == ShadowRay::past_lamp) stages.shadow_ray = shadow_ray_past_lamp;
}

void choose(ShadowFilter filter, Stages& stages) {
    if (filter == ShadowFilter::four) stages.shadow_texels = four_shadow_texels;
}

void choose(DepthTest test, const DepthRules& rules, Stages& stages) {
    const bool is_float = rules.bits == 0;
    switch (test) {
    case DepthTest::inverse_z:
        // The lab's test is right for any float if larger is nearer.
        if (rules.epsilon > 0.0f)
            stages.depth_test = depth_test_with_epsilon;
        else if (!is_float || is_smaller_nearer(rules.projection.clip_depth))
            stages.depth_test = depth_test_as_held;
        break;
    case DepthTest::linear_z:
        stages.depth_test = depth_test_linear_z;
        break;
    case DepthTest::off:
        stages.depth_test = is_float ? no_depth_test : no_depth_test_as_held;
        break;
    case DepthTest::reversed:
        stages.depth_test = depth_test_reversed;
        break;
    case DepthTest::or_equal:
        stages.depth_test = depth_test_or_equal;
        break;
    }
}

void choose(DepthIndex index, Stages& stages) {
    if (index == DepthIndex::transposed) stages.depth_cell = depth_cell_transposed;
}

void choose(Blend blend, Stages& stages) {
    switch (blend) {
    case Blend::over:
        break;
    case Blend::off:
        stages.blend = blend_nothing;
        break;
    case Blend::swapped:
        stages.blend = blend_swapped;
        break;
    }
}

void choose(Bounds bounds, Stages& stages) {
    if (bounds == Bounds::excludes_zero) stages.drawn_area = drawn_area_without_zero;
}

void choose(Encoding encoding, Stages& stages) {
    switch (encoding) {
    case Encoding::linear:
        break;
    case Encoding::srgb:
        stages.screen.encode = encode_srgb;
        break;
    case Encoding::gamma:
        stages.screen.encode = encode_gamma;
        break;
    }
}

void choose(ColourOverOne over_one, Stages& stages) {
    if (over_one == ColourOverOne::clamp) return;
    stages.screen.to_byte = to_byte_wrapped;
    stages.screen.visible_channel = visible_channel_wrapped;
}

void choose(ChannelOrder order, Stages& stages) {
    if (order == ChannelOrder::bgr) stages.screen.arrange = blue_first;
}

template <bool normals_differ>
auto varyings_read_with(bool colours_differ) {
    return colours_differ ? varyings_read_by_surfaces<normals_differ, true>
                          : varyings_read_by_surfaces<normals_differ, false>;
}

/// The lab's pixel shader, unless the settings need something that it does not have.
void choose_shader(const Settings& settings, const Scene& scene, Stages& stages) {
    const CornerDifferences& differences = scene.mesh.differences();
    const Shading shading = shading_rule(settings);
    const bool has_normals = differences.normals && shading == Shading::phong;
    const bool has_colours =
        differences.colours && (shading == Shading::unlit || shading == Shading::phong);
    const bool shines = settings.light.model != LightModel::lambert && shading == Shading::phong;
    const bool is_shaded = settings.shadows != Shadows::off && shading == Shading::phong;
    const bool is_bent = bends_normals(settings) && has_normal_map(scene);
    const bool is_turned =
        settings.light_rules.sides == LightSides::two && shading == Shading::phong;
    if (!has_normals && !has_colours && !shines && !is_shaded && !is_bent && !is_turned &&
        shading != Shading::flat)
        return;
    stages.pixel_shader = surface_shader;
    stages.varyings_read = differences.normals ? varyings_read_with<true>(differences.colours)
                                               : varyings_read_with<false>(differences.colours);
}

} // namespace

Stages choose_stages(const Settings& settings, const Scene& scene) {
    Stages stages = choose_stages(settings);
    choose_shader(settings, scene, stages);
    return stages;
}

Stages choose_stages(const Settings& settings) {
    Stages stages;
    choose(settings.rotation, stages);
    choose(camera_move_rule(settings), stages);
    choose(settings.image_axes, divided_by_rule(settings),
           clip_depth_rule(settings, SceneSpace::world), stages);
    choose(settings.transform, settings.rotation, settings.image_axes, stages);
    choose(settings.transform, settings.translation, stages);
    choose(settings.normal_w, stages);
    choose(settings.reject, stages);
    choose(settings.clip, stages);
    choose(settings.cull, stages);
    choose(settings.behind_mark, stages);
    choose(settings.outside_picture, stages);
    choose(settings.line_walk, stages);
    choose(settings.line, settings, stages);
    choose_coverage(settings, stages);
    choose(settings.interpolation, stages);
    choose(settings.texture_filter, stages);
    choose(settings.texture_wrap, stages);
    choose(settings.texel_rule, settings.texture_wrap, stages);
    choose(settings.normal_map_rule, stages);
    choose(settings.normal_map_space, stages);
    choose(settings.light_rules, stages);
    choose(settings.shadows, stages);
    choose(settings.shadow_ray, stages);
    choose(settings.shadow_filter, stages);
    choose(depth_rule(settings), depth_rules(settings, SceneSpace::world), stages);
    choose(settings.depth_index, stages);
    choose(settings.blend, stages);
    choose(settings.bounds, stages);
    choose(settings.encoding, stages);
    choose(settings.colour_over_one, stages);
    choose(settings.channel_order, stages);
    return stages;
}

} // namespace rasterwalk
