#include "settings/stage_functions.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/text_parts.h"
#include "mistakes/blend.h"
#include "mistakes/clip.h"
#include "mistakes/coverage.h"
#include "mistakes/cull.h"
#include "mistakes/depth_test.h"
#include "mistakes/hidden.h"
#include "mistakes/highlight.h"
#include "mistakes/interpolate.h"
#include "mistakes/light.h"
#include "mistakes/lines.h"
#include "mistakes/normal_map.h"
#include "mistakes/parallax.h"
#include "mistakes/project.h"
#include "mistakes/put_pixel.h"
#include "mistakes/samples.h"
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

/// The name of a function, without template arguments.
template <auto function>
constexpr std::string_view name_of() {
    constexpr std::string_view name = spelling<function>();
    return name.substr(0, name.find('<'));
}

// How a row puts its function into its slot.

template <class Function>
Function& slot_in(Stages& stages, Function Stages::*slot) {
    return stages.*slot;
}
template <class Function>
Function& slot_in(Stages& stages, Function ScreenRules::*slot) {
    return stages.screen.*slot;
}

/// The function itself is in the slot.
template <auto slot, auto function>
constexpr SlotFunction put{
    spelling<slot>(), name_of<function>(), false,
    [](Stages& stages, const Settings&, const Scene*) { slot_in(stages, slot) = function; }};

/// The slot holds what `combine` makes of all settings.
template <auto slot, auto function, void (*combine)(Stages&, const Settings&, const Scene*)>
constexpr SlotFunction part{spelling<slot>(), name_of<function>(), true, combine};

// The slots whose functions are made of parts, each part chosen by a setting of its own.

template <auto project>
auto with_axes(ImageAxes axes) {
    if (axes == ImageAxes::mirrored) return to_clip_space_with<axes_mirrored, project>;
    if (axes == ImageAxes::exchanged) return to_clip_space_with<axes_exchanged, project>;
    return project;
}

template <auto project>
auto with_divisor(const Settings& s) {
    return divided_by_rule(s) == DividedBy::z
               ? with_axes<project>(s.image_axes)
               : with_axes<to_clip_space_by_distance<project>>(s.image_axes);
}

void put_projection(Stages& stages, const Settings& s, const Scene*) {
    // Only perspective with 1/z is the lab's.
    stages.to_clip_space = clip_depth_rule(s, SceneSpace::world) == ClipDepth::inv_z
                               ? with_divisor<to_clip_space>(s)
                               : with_divisor<to_clip_space_mixed>(s);
}

template <bool is_transposed>
auto with_matrices(ImageAxes axes) {
    if (axes == ImageAxes::mirrored) return mistaken_matrices<is_transposed, axes_mirrored>;
    if (axes == ImageAxes::exchanged) return mistaken_matrices<is_transposed, axes_exchanged>;
    if constexpr (is_transposed)
        return mistaken_matrices<true, axes_kept>;
    else
        return vertex_shader_by_matrices;
}

void put_matrices(Stages& stages, const Settings& s, const Scene*) {
    stages.vertex_shader = s.rotation == Rotation::row_vector ? with_matrices<false>(s.image_axes)
                                                              : with_matrices<true>(s.image_axes);
}

template <auto slot>
void put_mixed_weight(Stages& stages, const Settings& s, const Scene* scene) {
    slot_in(stages, slot) = mixed_weight;
    stages.mixed_weight = mixed_weight_rule(s, scene != nullptr ? scene->space : SceneSpace::world);
}

void put_corner_snap(Stages& stages, const Settings& s, const Scene*) {
    switch (s.snap) {
    case Snap::pixel:
        stages.snap = snap_for_corners<snap_to_centre>;
        break;
    case Snap::sixteenth:
        stages.snap = snap_for_corners<snap_to_sixteenth>;
        break;
    case Snap::subpixel:
        stages.snap = snap_for_corners<snap_to_subpixel>;
        break;
    }
}

void put_parallax_step(Stages& stages, const Settings& s, const Scene*) {
    const bool is_divided = s.parallax == Parallax::divided;
    if (s.parallax_rule == ParallaxRule::subtracted)
        stages.parallax_step =
            is_divided ? step_subtracted<step_divided> : step_subtracted<step_limited>;
    else
        stages.parallax_step = is_divided ? step_divided : step_limited;
}

// The parts of the light, in the order of the words of LightDirection, LightFalloff and LightSum.

struct LightVector {
    decltype(&vector_to_lamp) lamp_vector;
    decltype(&own_square) square;
    decltype(&own_length) length;
};
constexpr std::array light_vectors{LightVector{vector_to_lamp, own_square, own_length},
                                   LightVector{vector_from_lamp, own_square, own_length},
                                   LightVector{vector_to_lamp, own_square, not_normalized},
                                   LightVector{vector_to_lamp, square_with_w, own_length}};
constexpr std::array light_areas{sphere_area, area_without_4pi,     area_of_distance,  area_of_one,
                                 cubed_area,  area_with_pi_of_atan, area_with_pi_three};
constexpr std::array light_sums{reflectance_times, reflectance_plus, reflectance_twice};
static_assert(light_vectors.size() == enum_words<LightDirection>.size());
static_assert(light_areas.size() == enum_words<LightFalloff>.size());
static_assert(light_sums.size() == enum_words<LightSum>.size());

/// A light for each combination of parts; the sum changes fastest, then the area.
template <std::size_t... i>
constexpr auto lights_of(std::index_sequence<i...>) {
    constexpr std::size_t sums = light_sums.size(), in_a_way = light_areas.size() * sums;
    return std::array{
        mistaken_light<light_vectors[i / in_a_way].lamp_vector, light_vectors[i / in_a_way].square,
                       light_vectors[i / in_a_way].length,
                       light_areas[i / sums % light_areas.size()], light_sums[i % sums]>...};
}

void put_light(Stages& stages, const Settings& s, const Scene*) {
    static constexpr auto lights = lights_of(
        std::make_index_sequence<light_vectors.size() * light_areas.size() * light_sums.size()>());
    const LightRules& rules = s.light_rules;
    const auto lamp_vector = static_cast<std::size_t>(rules.direction);
    const auto area = static_cast<std::size_t>(rules.falloff);
    const auto sum = static_cast<std::size_t>(rules.sum);
    stages.reflected_light =
        lights[(lamp_vector * light_areas.size() + area) * light_sums.size() + sum];
}

template <bool normals_differ>
auto varyings_read_with(bool colours_differ) {
    return colours_differ ? varyings_read_by_surfaces<normals_differ, true>
                          : varyings_read_by_surfaces<normals_differ, false>;
}

/// In place of the lab's pixel shader, with the varyings that it reads.
void put_surface_shader(Stages& stages, const Settings&, const Scene* scene) {
    const CornerDifferences& differences = scene->mesh.differences();
    stages.pixel_shader = surface_shader;
    stages.varyings_read = differences.normals ? varyings_read_with<true>(differences.colours)
                                               : varyings_read_with<false>(differences.colours);
}
constexpr SlotFunction surfaces = part<&Stages::pixel_shader, surface_shader, put_surface_shader>;

/// The chosen coverage, once for each sample.
void put_sample_rows(Stages& stages, const Settings& s, const Scene*) {
    switch (s.coverage) {
    case Coverage::rows:
        break;
    case Coverage::edge_functions:
        stages.compute_polygon_rows = rows_of_samples<rows_by_edge_functions>;
        break;
    case Coverage::scan_conversion:
        stages.compute_polygon_rows = rows_of_samples<rows_by_scan_conversion>;
        break;
    case Coverage::active_edges:
        stages.compute_polygon_rows = rows_of_samples<rows_by_active_edges>;
        break;
    }
}
constexpr SlotFunction sample_rows =
    part<&Stages::compute_polygon_rows, rows_of_samples<rows_by_edge_functions>, put_sample_rows>;

// What lets a word act.

bool always(const Settings&, const Scene*) {
    return true;
}
bool by_labs_lines(const Settings& s, const Scene*) {
    return s.transform == Transform::lab;
}
bool by_matrices(const Settings& s, const Scene*) {
    return s.transform == Transform::matrices;
}
bool if_divided_wrongly(const Settings& s, const Scene*) {
    return divided_by_rule(s) == DividedBy::distance;
}
bool if_mixed(const Settings& s, const Scene*) {
    return s.projection_mix > 0.0f;
}
bool by_interpolate(const Settings& s, const Scene*) {
    return s.line == LineAlgorithm::interpolate;
}
bool by_bresenham(const Settings& s, const Scene*) {
    return s.line == LineAlgorithm::bresenham;
}
bool by_row_table(const Settings& s, const Scene*) {
    return coverage_rule(s) == Coverage::rows;
}
bool at_centres(const Settings& s, const Scene*) {
    return coverage_rule(s) != Coverage::rows;
}
bool by_edge_functions(const Settings& s, const Scene*) {
    return coverage_rule(s) == Coverage::edge_functions;
}
bool with_samples(const Settings& s, const Scene*) {
    return sampling_rule(s) != Sampling::centre;
}
bool if_multisampled(const Settings& s, const Scene*) {
    return sampling_rule(s) == Sampling::multisample;
}
bool if_supersampled(const Settings& s, const Scene*) {
    return sampling_rule(s) == Sampling::supersample;
}
/// The interval between the edges is that of the pixels' centres.
bool by_intervals(const Settings& s, const Scene* scene) {
    return by_edge_functions(s, scene) && !with_samples(s, scene);
}
bool if_repeated(const Settings& s, const Scene*) {
    return s.texture_wrap == TextureWrap::repeat;
}
bool from_depth_on(const Settings& s, const Scene*) {
    return s.stage >= Stage::depth;
}
bool by_draw_order(const Settings& s, const Scene*) {
    return draw_order_rule(s) != DrawOrder::scene;
}
bool in_scenes_order(const Settings& s, const Scene* scene) {
    return !by_draw_order(s, scene);
}
bool by_labs_depth_test(const Settings& s, const Scene*) {
    return depth_rule(s) == DepthTest::inverse_z;
}
bool without_depth_test(const Settings& s, const Scene*) {
    return depth_rule(s) == DepthTest::off;
}
bool if_ties_count(const Settings& s, const Scene*) {
    return depth_epsilon_rule(s) > 0.0f;
}

// The same for what the lab's pixel shader does not have; without a scene it stays.

bool if_lit(const Settings& s, const Scene* scene) {
    return scene != nullptr && s.stage >= Stage::shade;
}
bool at_pixels(const Settings& s, const Scene* scene) {
    return scene != nullptr && shading_rule(s) == Shading::phong;
}
bool if_normals_differ(const Settings& s, const Scene* scene) {
    return at_pixels(s, scene) && scene->mesh.differences().normals;
}
bool if_colours_differ(const Settings& s, const Scene* scene) {
    return scene != nullptr && scene->mesh.differences().colours &&
           (shading_rule(s) == Shading::unlit || shading_rule(s) == Shading::phong);
}
bool if_bumpy(const Settings& s, const Scene* scene) {
    return at_pixels(s, scene) && has_normal_map(*scene);
}

/// A row as it is written below.
struct RegistryRow {
    std::string_view choice; ///< "clip=near|all": a setting and the words; or just a setting
    SlotFunction does;
    std::string_view file;
    bool (*acts)(const Settings&, const Scene*) = always;
};

const RegistryRow registry_rows[] = {
    // World to clip space.
    {"rotation=transposed", put<&Stages::rotate_to_camera, rotate_transposed>,
     "mistakes/vertex_shader.h"},
    {"camera_move=added", put<&Stages::to_camera_space, to_camera_by_adding>,
     "mistakes/vertex_shader.h", by_labs_lines},
    {"camera_move=rotated_first", put<&Stages::to_camera_space, to_camera_rotated_first>,
     "mistakes/vertex_shader.h", by_labs_lines},
    {"depth_format=ndc_32|ndc_24|ndc_16|reversed_32|reversed_24|reversed_16",
     part<&Stages::to_clip_space, to_clip_space_mixed, put_projection>, "stages/orthographic.h"},
    {"projection=orthographic", part<&Stages::to_clip_space, to_clip_space_mixed, put_projection>,
     "stages/orthographic.h"},
    {"projection_mix", part<&Stages::to_clip_space, to_clip_space_mixed, put_projection>,
     "stages/orthographic.h", if_mixed},
    {"divided_by=distance",
     part<&Stages::to_clip_space, to_clip_space_by_distance<to_clip_space>, put_projection>,
     "mistakes/vertex_shader.h", if_divided_wrongly},
    {"image_axes=mirrored", part<&Stages::to_clip_space, axes_mirrored, put_projection>,
     "mistakes/vertex_shader.h"},
    {"image_axes=exchanged", part<&Stages::to_clip_space, axes_exchanged, put_projection>,
     "mistakes/vertex_shader.h"},
    {"image_axes=uncentred", put<&Stages::viewport_middle, middle_in_corner>, "mistakes/project.h"},
    {"transform=matrices", part<&Stages::vertex_shader, vertex_shader_by_matrices, put_matrices>,
     "stages/matrices.h"},
    {"rotation=transposed",
     part<&Stages::vertex_shader, mistaken_matrices<true, axes_kept>, put_matrices>,
     "mistakes/vertex_shader.h", by_matrices},
    {"image_axes=mirrored", part<&Stages::vertex_shader, axes_mirrored, put_matrices>,
     "mistakes/vertex_shader.h", by_matrices},
    {"image_axes=exchanged", part<&Stages::vertex_shader, axes_exchanged, put_matrices>,
     "mistakes/vertex_shader.h", by_matrices},
    {"translation=bottom_row", put<&Stages::view_matrix, view_matrix_with_bottom_row>,
     "mistakes/vertex_shader.h", by_matrices},
    {"normal_w=one", put<&Stages::light_normal, light_normal_as_place>, "mistakes/light.h"},

    // What is left out, and what is cut.
    {"reject=outcodes|cheap", put<&Stages::reject, reject_by_outcodes>, "stages/reject.h"},
    {"reject=cheap", put<&Stages::walked_area, walk_in_picture>, "stages/put_pixel.h"},
    {"clip=none|after_division", put<&Stages::is_in_front, is_in_front_unasked>,
     "mistakes/project.h"},
    {"clip=near|all|guard_band", put<&Stages::is_in_front, has_positive_w>, "stages/project.h"},
    {"clip=near", put<&Stages::clip, clip_near>, "stages/clip.h"},
    {"clip=all", put<&Stages::clip, clip_all>, "stages/clip.h"},
    {"clip=guard_band", put<&Stages::clip, clip_guard_band>, "stages/clip.h"},
    {"clip=whole_only", put<&Stages::clip, drop_partly_outside>, "mistakes/clip.h"},
    {"clip=wrong_t", put<&Stages::clip, clip_near_with_wrong_t>, "mistakes/clip.h"},
    {"clip=after_division", put<&Stages::clip, clip_after_division>, "mistakes/clip.h"},
    {"clip=clamped", put<&Stages::clip, move_to_near_plane>, "mistakes/clip.h"},
    {"clip=uncut_varyings", put<&Stages::clip, clip_near_with_uncut_varyings>, "mistakes/clip.h"},
    {"cull=face_normal", put<&Stages::cull, cull_by_face_normal>, "stages/cull.h"},
    {"cull=screen_area", put<&Stages::cull, cull_by_screen_area>, "stages/cull.h"},
    {"cull=vertex_normals", put<&Stages::cull, cull_by_vertex_normals>, "stages/cull.h"},
    {"cull=fragment_normal", put<&Stages::cull_fragment, cull_by_fragment_normal>, "stages/cull.h"},
    {"cull=view_axis", put<&Stages::cull, cull_by_view_axis>, "mistakes/cull.h"},
    {"cull=lamp", put<&Stages::cull, cull_by_lamp>, "mistakes/cull.h"},
    {"behind_mark=minus_one", put<&Stages::project, project_marking_column>, "mistakes/project.h"},
    {"outside_picture=clamped", put<&Stages::snap_to_pixel, snap_into_picture>,
     "mistakes/project.h"},

    // Lines.
    {"line_walk=multiply", put<&Stages::interpolate, interpolate_by_multiplying>,
     "stages/interpolate.h"},
    {"line_walk=exact", put<&Stages::interpolate, interpolate_exactly>, "stages/interpolate.h"},
    {"line_walk=integer_step", put<&Stages::line_step, line_step_of_integers>,
     "mistakes/interpolate.h"},
    {"line_walk=short_step", put<&Stages::line_step, line_step_by_samples>,
     "mistakes/interpolate.h"},
    {"line_walk=zinv_falls", put<&Stages::row_fragments, row_fragments_with_falling_zinv>,
     "mistakes/interpolate.h"},
    {"line=bresenham", put<&Stages::line, line_by_bresenham>, "stages/lines.h"},
    {"line=midpoint", put<&Stages::line, line_by_midpoint>, "stages/lines.h"},
    {"line=dda", put<&Stages::line, line_by_dda>, "stages/lines.h"},
    {"edge_samples=rows", put<&Stages::edge_sample_count, edge_sample_count_by_rows>,
     "mistakes/coverage.h", by_interpolate},
    {"edge_samples=shifted", put<&Stages::edge_sample_count, edge_sample_count_shifted>,
     "mistakes/coverage.h", by_interpolate},
    {"edge_samples=without_last", put<&Stages::entered_samples, entered_without_last>,
     "mistakes/coverage.h", by_interpolate},
    {"edge_samples=no_last_edge", put<&Stages::entered_samples, entered_without_last_edge>,
     "mistakes/coverage.h", by_interpolate},
    {"bresenham_rule=first_octant", put<&Stages::line, line_in_first_octant>, "mistakes/lines.h",
     by_bresenham},
    {"bresenham_rule=first_octant", put<&Stages::edge_sample_count, edge_sample_count_to_the_right>,
     "mistakes/lines.h", by_bresenham},
    {"bresenham_rule=wrong_term", put<&Stages::line, line_by_wrong_term>, "mistakes/lines.h",
     by_bresenham},

    // The row table.
    {"row_start=window", put<&Stages::begin_polygon_rows, begin_rows_at_picture>,
     "mistakes/coverage.h", by_row_table},
    {"row_start=window", put<&Stages::polygon_box, polygon_box_at_picture>, "mistakes/coverage.h",
     by_row_table},
    {"row_start=row_short", put<&Stages::begin_polygon_rows, begin_rows_without_last>,
     "mistakes/coverage.h", by_row_table},
    {"row_search=all_rows", put<&Stages::find_row, find_row_among_all>, "mistakes/coverage.h",
     by_row_table},
    {"row_search=clamped", put<&Stages::find_row, find_nearest_row>, "mistakes/coverage.h",
     by_row_table},
    {"row_search=column_only", put<&Stages::row_end, row_end_of_column>, "mistakes/coverage.h",
     by_row_table},
    {"empty_rows=overflow", put<&Stages::row_pixel_count, row_pixel_count_wrapped>,
     "mistakes/coverage.h", by_row_table},
    {"spans=single_skipped", put<&Stages::drawn_pixels, drawn_pixels_without_single>,
     "mistakes/coverage.h", by_row_table},
    {"spans=last_dropped", put<&Stages::drawn_pixels, drawn_pixels_without_last>,
     "mistakes/coverage.h", by_row_table},

    // Coverage at the centres of pixels.
    {"coverage=edge_functions", put<&Stages::compute_polygon_rows, rows_by_edge_functions>,
     "stages/edge_functions.h", at_centres},
    {"coverage=scan_conversion", put<&Stages::compute_polygon_rows, rows_by_scan_conversion>,
     "stages/scan_conversion.h", at_centres},
    {"coverage=active_edges", put<&Stages::compute_polygon_rows, rows_by_active_edges>,
     "stages/active_edges.h", at_centres},
    {"coverage=edge_functions|scan_conversion|active_edges", put<&Stages::polygon_box, snapped_box>,
     "stages/snap.h", at_centres},
    {"coverage=edge_functions", put<&Stages::row_fragments, fragments_by_weights>,
     "stages/edge_functions.h", at_centres},
    {"fill_rule=exclusive", put<&Stages::edge_owns_points, owns_exclusive>, "stages/fill_rule.h",
     at_centres},
    {"fill_rule=top_left", put<&Stages::edge_owns_points, owns_top_left>, "stages/fill_rule.h",
     at_centres},
    {"fill_rule=left_only", put<&Stages::edge_owns_points, owns_left_only>, "mistakes/coverage.h",
     at_centres},
    {"snap=sixteenth", put<&Stages::snap, snap_to_sixteenth>, "stages/snap.h", at_centres},
    {"snap=subpixel", put<&Stages::snap, snap_to_subpixel>, "stages/snap.h", at_centres},
    {"pixel_sample=corner", part<&Stages::snap, snap_for_corners<snap_to_centre>, put_corner_snap>,
     "mistakes/coverage.h", at_centres},
    {"box_walk=interval", put<&Stages::tested_columns, columns_between_crossings>,
     "stages/edge_functions.h", by_intervals},
    {"weight_edge=own", put<&Stages::weights, weights_of_own_edges>, "mistakes/coverage.h",
     by_edge_functions},

    // Pixels with several samples: the coverage above for each of them, and values that are mixed
    // from the corners wherever they are wanted.
    {"samples", sample_rows, "stages/samples.h", if_multisampled},
    {"samples", put<&Stages::row_fragments, fragments_by_weights>, "stages/edge_functions.h",
     if_multisampled},
    {"supersample", sample_rows, "stages/samples.h", if_supersampled},
    {"supersample", put<&Stages::row_fragments, fragments_by_weights>, "stages/edge_functions.h",
     if_supersampled},
    {"supersample", put<&Stages::sample_place, square_grid>, "stages/samples.h", if_supersampled},
    {"sample_rule=late_clamp", put<&Stages::resolve, mean_clamped_late>, "mistakes/samples.h",
     with_samples},
    {"sample_rule=centre_depth", put<&Stages::fragment_at_sample, fragment_of_centre>,
     "mistakes/samples.h", with_samples},

    // Between the vertices.
    {"interpolation=affine", put<&Stages::varying_weight, varying_weight_one>,
     "mistakes/interpolate.h"},
    {"interpolation=affine|undivided", put<&Stages::recovery_weight, varying_weight_one>,
     "mistakes/interpolate.h"},
    {"interpolation=mixed",
     part<&Stages::varying_weight, mixed_weight, put_mixed_weight<&Stages::varying_weight>>,
     "stages/pixel_shader.h"},
    {"interpolation=mixed",
     part<&Stages::recovery_weight, mixed_weight, put_mixed_weight<&Stages::recovery_weight>>,
     "stages/pixel_shader.h"},
    {"interpolation=zinv_twice", put<&Stages::span_end, span_end_times_zinv>,
     "mistakes/interpolate.h"},
    {"interpolation=divided_twice", put<&Stages::recovery_weight, recovery_weight_squared>,
     "mistakes/interpolate.h"},

    // Textures.
    {"texture_filter=bilinear", put<&Stages::sample_texture, sample_bilinear>,
     "stages/texture_lookup.h"},
    {"texture_filter=mipmap", put<&Stages::sample_texture, sample_mipmap>,
     "stages/texture_lookup.h"},
    {"texture_filter=trilinear", put<&Stages::sample_texture, sample_trilinear>,
     "stages/texture_lookup.h"},
    {"texture_wrap=clamp", put<&Stages::wrap_texel, wrap_clamp>, "stages/texture_lookup.h"},
    {"texture_wrap=mirror", put<&Stages::wrap_texel, wrap_mirror>, "stages/texture_lookup.h"},
    {"texel_rule=upside_down", put<&Stages::texel_place, texel_place_upside_down>,
     "mistakes/texture.h"},
    {"texel_rule=whole_centres", put<&Stages::texel_place, texel_place_of_whole_centres>,
     "mistakes/texture.h"},
    {"texel_rule=remainder", put<&Stages::wrap_texel, wrap_by_remainder>, "mistakes/texture.h",
     if_repeated},
    {"texel_rule=remainder", put<&Stages::read_texel, read_texel_in_memory>, "mistakes/texture.h",
     if_repeated},
    {"texel_rule=level_along_x", put<&Stages::texture_level, texture_level_along_x>,
     "mistakes/texture.h"},
    {"normal_map_rule=green_turned", put<&Stages::arrow_of_texel, arrow_with_green_turned>,
     "mistakes/normal_map.h"},
    {"normal_map_rule=mirror_missed", put<&Stages::tangent_frame, tangent_frame_unasked>,
     "mistakes/normal_map.h"},
    {"normal_map_rule=undecoded", put<&Stages::arrow_of_texel, arrow_undecoded>,
     "mistakes/normal_map.h"},
    {"normal_map_space=tangent", put<&Stages::light_space, tangent_space>, "stages/normal_map.h"},
    {"parallax=divided", part<&Stages::parallax_step, step_divided, put_parallax_step>,
     "stages/parallax.h"},
    {"parallax_rule=subtracted",
     part<&Stages::parallax_step, step_subtracted<step_limited>, put_parallax_step>,
     "mistakes/parallax.h"},

    // Light and shadow.
    {"light.highlight=unasked", put<&Stages::highlight, highlight_unasked>, "mistakes/highlight.h"},
    {"light.highlight=long_half", put<&Stages::highlight, highlight_with_long_half>,
     "mistakes/highlight.h"},
    {"light.renormalize=off", put<&Stages::unit_normal, normal_as_interpolated>,
     "mistakes/highlight.h"},
    {"light.sides=two", put<&Stages::light_side, side_of_eye>, "stages/light_side.h"},
    {"light.direction=from_light", part<&Stages::reflected_light, vector_from_lamp, put_light>,
     "mistakes/light.h"},
    {"light.direction=not_normalized", part<&Stages::reflected_light, not_normalized, put_light>,
     "mistakes/light.h"},
    {"light.direction=with_w", part<&Stages::reflected_light, square_with_w, put_light>,
     "mistakes/light.h"},
    {"light.falloff=no_4pi", part<&Stages::reflected_light, area_without_4pi, put_light>,
     "stages/light.h"},
    {"light.falloff=linear", part<&Stages::reflected_light, area_of_distance, put_light>,
     "stages/light.h"},
    {"light.falloff=none", part<&Stages::reflected_light, area_of_one, put_light>,
     "stages/light.h"},
    {"light.falloff=cubed", part<&Stages::reflected_light, cubed_area, put_light>,
     "mistakes/light.h"},
    {"light.falloff=pi_of_atan", part<&Stages::reflected_light, area_with_pi_of_atan, put_light>,
     "mistakes/light.h"},
    {"light.falloff=pi_three", part<&Stages::reflected_light, area_with_pi_three, put_light>,
     "mistakes/light.h"},
    {"light.sum=reflectance_plus", part<&Stages::reflected_light, reflectance_plus, put_light>,
     "mistakes/light.h"},
    {"light.sum=reflectance_twice", part<&Stages::reflected_light, reflectance_twice, put_light>,
     "mistakes/light.h"},
    {"shadows=rays", put<&Stages::shadow, shadow_by_ray>, "stages/shadow.h"},
    {"shadows=map", put<&Stages::shadow, shadow_by_map>, "stages/shadow.h"},
    {"shadow_ray=past_lamp", put<&Stages::shadow_ray, shadow_ray_past_lamp>, "mistakes/shadow.h"},
    {"shadow_filter=four", put<&Stages::shadow_texels, four_shadow_texels>, "stages/shadow.h"},

    // Hidden surfaces: with the right order every fragment may cover what is there.
    {"painter_rule=nearest_corner", put<&Stages::painter_depth, nearest_depth>, "mistakes/hidden.h",
     in_scenes_order},
    {"painter_rule=near_first", put<&Stages::is_drawn_before, is_nearer_drawn_before>,
     "stages/painter.h", in_scenes_order},
    {"draw_order=near_first", put<&Stages::is_drawn_before, is_nearer_drawn_before>,
     "stages/painter.h", by_draw_order},
    {"bsp_rule=exchanged", put<&Stages::is_near_side, is_far_side>, "mistakes/hidden.h"},

    // Depth: the lab's test is right for any float if larger is nearer.
    {"depth_test=linear_z", put<&Stages::depth_test, depth_test_linear_z>, "mistakes/depth_test.h",
     from_depth_on},
    {"depth_test=reversed", put<&Stages::depth_test, depth_test_reversed>, "mistakes/depth_test.h",
     from_depth_on},
    {"depth_test=or_equal", put<&Stages::depth_test, depth_test_or_equal>, "mistakes/depth_test.h",
     from_depth_on},
    {"depth_test=raced", put<&Stages::depth_test, depth_test_raced>, "mistakes/depth_test.h",
     from_depth_on},
    {"depth_test=off", put<&Stages::depth_test, no_depth_test>, "stages/depth_test.h"},
    {"hidden=painter|bsp|warnock", put<&Stages::depth_test, no_depth_test>, "stages/depth_test.h",
     from_depth_on},
    {"stage=points|edges|rows|fill", put<&Stages::depth_test, no_depth_test>,
     "stages/depth_test.h"},
    {"depth_format=inv_z_24|inv_z_16|ndc_24|ndc_16|reversed_24|reversed_16",
     put<&Stages::depth_test, no_depth_test_in_buffer>, "stages/depth_test.h", without_depth_test},
    {"depth_format=inv_z_24|inv_z_16|ndc_32|ndc_24|ndc_16|reversed_24|reversed_16",
     put<&Stages::depth_test, depth_test_in_buffer>, "stages/depth_test.h", by_labs_depth_test},
    {"depth_epsilon", put<&Stages::depth_test, depth_test_with_epsilon>, "stages/depth_test.h",
     if_ties_count},
    {"depth_index=transposed", put<&Stages::depth_cell, depth_cell_transposed>,
     "mistakes/depth_test.h"},

    // The picture.
    {"blend=off", put<&Stages::blend, blend_nothing>, "stages/blend.h"},
    {"blend=swapped", put<&Stages::blend, blend_swapped>, "mistakes/blend.h"},
    {"bounds=excludes_zero", put<&Stages::drawn_area, drawn_area_without_zero>,
     "mistakes/put_pixel.h"},
    {"encoding=srgb", put<&ScreenRules::encode, encode_srgb>, "stages/put_pixel.h"},
    {"encoding=gamma", put<&ScreenRules::encode, encode_gamma>, "mistakes/put_pixel.h"},
    {"colour_over_one=wrap", put<&ScreenRules::to_byte, to_byte_wrapped>, "mistakes/put_pixel.h"},
    {"colour_over_one=wrap", put<&ScreenRules::visible_channel, visible_channel_wrapped>,
     "mistakes/put_pixel.h"},
    {"channel_order=bgr", put<&ScreenRules::arrange, blue_first>, "mistakes/put_pixel.h"},

    // The pixel shader, if the lab's does not have what the settings need.
    {"shading=flat", surfaces, "stages/surface_shader.h", if_lit},
    {"shading=phong", surfaces, "stages/surface_shader.h", if_normals_differ},
    {"shading=unlit|phong", surfaces, "stages/surface_shader.h", if_colours_differ},
    {"stage=points|edges|rows|fill|depth", surfaces, "stages/surface_shader.h", if_colours_differ},
    {"light.model=blinn_phong", surfaces, "stages/surface_shader.h", at_pixels},
    {"light.sides=two", surfaces, "stages/surface_shader.h", at_pixels},
    {"shadows=rays|map", surfaces, "stages/surface_shader.h", at_pixels},
    {"normal_map=on", surfaces, "stages/surface_shader.h", if_bumpy},
};

/// Looks up the words of the rows, one row for each.
std::vector<StageFunction> make_stage_functions() {
    std::vector<StageFunction> functions;
    for (const RegistryRow& row : registry_rows) {
        std::string_view words = row.choice;
        const Setting* const setting = find_setting(take_part(words, '='));
        if (setting == nullptr) throw std::logic_error(std::string(row.choice));
        if (words.empty()) functions.push_back({setting, {}, row.does, row.file, row.acts});
        while (!words.empty()) {
            const std::string_view word = take_part(words, '|');
            const auto& all = std::get<ChoiceSetting>(setting->kind).words;
            const auto found = std::find(all.begin(), all.end(), word);
            if (found == all.end()) throw std::logic_error(std::string(row.choice));
            functions.push_back({setting, word, row.does, row.file, row.acts,
                                 static_cast<int>(found - all.begin())});
        }
    }
    return functions;
}

} // namespace

std::span<const StageFunction> stage_functions() {
    static const std::vector<StageFunction> functions = make_stage_functions();
    return functions;
}

std::vector<const StageFunction*> find_functions(std::string_view setting, std::string_view word) {
    std::vector<const StageFunction*> found;
    for (const StageFunction& row : stage_functions()) {
        if (row.setting->name == setting && (word.empty() || row.word == word))
            found.push_back(&row);
    }
    return found;
}

bool is_chosen(const StageFunction& row, const Settings& settings, const Scene* scene) {
    if (!row.acts(settings, scene)) return false;
    return row.word.empty() ||
           std::get<ChoiceSetting>(row.setting->kind).read(settings) == row.word_place;
}

std::vector<const StageFunction*> functions_in_use(const Settings& settings, const Scene* scene) {
    std::vector<const StageFunction*> used;
    for (const StageFunction& row : stage_functions()) {
        if (!is_chosen(row, settings, scene)) continue;
        if (!row.does.is_part) {
            std::erase_if(used, [&](const StageFunction* earlier) {
                return earlier->does.slot == row.does.slot;
            });
        }
        used.push_back(&row);
    }
    return used;
}

} // namespace rasterwalk
