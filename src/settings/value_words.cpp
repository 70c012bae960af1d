#include "settings/value_words.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// A word that does not explain itself, and how it is said.
struct ChoiceWords {
    std::string_view setting; ///< empty: any
    std::string_view word, said;
};

constexpr ChoiceWords choice_word_list[] = {
    {"", "truncate", "cut toward 0"},
    {"", "floor", "rounded down"},
    {"", "round", "to the nearest"},
    {"vertex_rounding", "truncate_sum", "moved, then cut"},
    {"shading", "unlit", "nowhere"},
    {"engine", "steps", "the steps"},
    {"engine", "fast", "the fast engine"},
    {"shading", "flat", "per triangle"},
    {"shading", "gouraud", "at the vertices"},
    {"shading", "phong", "at every pixel"},
    {"coverage", "rows", "the row table"},
    {"coverage", "active_edges", "active edges"},
    {"fill_rule", "inclusive", "drawn by all"},
    {"fill_rule", "exclusive", "drawn by none"},
    {"fill_rule", "top_left", "top and left edges"},
    {"fill_rule", "left_only", "only left edges"},
    {"snap", "pixel", "pixel centres"},
    {"snap", "sixteenth", "16ths of a pixel"},
    {"pixel_sample", "centre", "its centre"},
    {"pixel_sample", "corner", "its corner"},
    {"weight_edge", "opposite", "the opposite edge"},
    {"weight_edge", "own", "an adjacent edge"},
    {"line", "interpolate", "Interpolate"},
    {"line", "bresenham", "Bresenham"},
    {"line", "dda", "DDA"},
    {"bresenham_rule", "right", "all octants"},
    {"line_walk", "accumulate", "steps added up"},
    {"line_walk", "multiply", "steps multiplied"},
    {"line_walk", "exact", "without error"},
    {"line_walk", "integer_step", "whole steps"},
    {"line_walk", "short_step", "steps too short"},
    {"line_walk", "zinv_falls", "1/z the wrong way"},
    {"edge_samples", "longest_axis", "the longer axis"},
    {"edge_samples", "rows", "one per row"},
    {"edge_samples", "shifted", "|a − b + 1|"},
    {"edge_samples", "without_last", "all but the last"},
    {"edge_samples", "no_last_edge", "no last edge"},
    {"row_start", "extreme", "the extremes"},
    {"row_start", "window", "the borders"},
    {"row_start", "row_short", "one row short"},
    {"row_search", "indexed", "by its number"},
    {"row_search", "all_rows", "among all rows"},
    {"row_search", "clamped", "the nearest one"},
    {"row_search", "column_only", "by x alone"},
    {"empty_rows", "overflow", "drawn"},
    {"spans", "inclusive", "with both ends"},
    {"spans", "single_skipped", "no single pixels"},
    {"spans", "last_dropped", "without the last"},
    {"hidden", "depth_buffer", "depth buffer"},
    {"hidden", "painter", "painter"},
    {"hidden", "bsp", "BSP tree"},
    {"painter_rule", "right", "by mean depth"},
    {"painter_rule", "nearest_corner", "by nearest corner"},
    {"painter_rule", "near_first", "nearest first"},
    {"bsp_rule", "right", "the far side"},
    {"bsp_rule", "exchanged", "the near side"},
    {"depth_test", "inverse_z", "by 1/z"},
    {"depth_test", "linear_z", "by z"},
    {"depth_test", "reversed", "farther wins"},
    {"depth_test", "or_equal", "by 1/z, with ≥"},
    {"depth_format", "inv_z", "1/z"},
    {"depth_format", "inv_z_24", "1/z, 24 bits"},
    {"depth_format", "inv_z_16", "1/z, 16 bits"},
    {"depth_format", "ndc_32", "NDC z"},
    {"depth_format", "ndc_24", "NDC z, 24 bits"},
    {"depth_format", "ndc_16", "NDC z, 16 bits"},
    {"depth_format", "reversed_32", "reversed z"},
    {"depth_format", "reversed_24", "reversed z, 24 bits"},
    {"depth_format", "reversed_16", "reversed z, 16 bits"},
    {"depth_index", "row_major", "[y][x]"},
    {"depth_index", "transposed", "[x][y]"},
    {"depth_order", "after_depth_test", "after the test"},
    {"depth_order", "before_depth_test", "before the test"},
    {"interpolation", "zinv_twice", "1/z twice"},
    {"texel_rule", "right", "as it should be"},
    {"texel_rule", "upside_down", "v from the bottom"},
    {"texel_rule", "whole_centres", "centres at i"},
    {"texel_rule", "remainder", "with i % n"},
    {"texel_rule", "level_along_x", "level along x"},
    {"normal_map_rule", "right", "as it should be"},
    {"normal_map_rule", "green_turned", "with green down"},
    {"normal_map_rule", "mirror_missed", "mirroring missed"},
    {"normal_map_rule", "undecoded", "without 2 c − 1"},
    {"normal_map_space", "world", "the world"},
    {"normal_map_space", "tangent", "tangent space"},
    {"camera.aim", "angles", "turn and tilt"},
    {"camera.aim", "look_at", "a target"},
    {"transform", "lab", "the lab's lines"},
    {"matrix_order", "row_vectors", "rows, v M"},
    {"matrix_order", "column_vectors", "columns, M v"},
    {"translation", "last_column", "in the last column"},
    {"translation", "bottom_row", "in the bottom row"},
    {"normal_w", "zero", "0"},
    {"normal_w", "one", "1"},
    {"rotation", "row_vector", "v R"},
    {"rotation", "transposed", "R v"},
    {"camera_move", "subtracted", "(v − C) R"},
    {"camera_move", "added", "(v + C) R"},
    {"camera_move", "rotated_first", "v R − C"},
    {"image_axes", "right_way", "right, down"},
    {"image_axes", "mirrored", "left, up"},
    {"image_axes", "exchanged", "down, right"},
    {"image_axes", "uncentred", "from the corner"},
    {"divided_by", "distance", "the distance"},
    {"behind_mark", "none", "no pixel"},
    {"behind_mark", "minus_one", "column −1"},
    {"reject", "outcodes", "by outcodes"},
    {"reject", "cheap", "cheap clipping"},
    {"clip", "none", "not at all"},
    {"clip", "near", "by the near plane"},
    {"clip", "all", "by all planes"},
    {"clip", "guard_band", "by a guard band"},
    {"clip", "whole_only", "only if all inside"},
    {"clip", "wrong_t", "with a wrong t"},
    {"clip", "clamped", "clamped to near"},
    {"clip", "uncut_varyings", "only the position"},
    {"cull", "face_normal", "by normal"},
    {"cull", "screen_area", "by winding"},
    {"cull", "vertex_normals", "by all normals"},
    {"cull", "fragment_normal", "by fragment"},
    {"cull", "view_axis", "by the view axis"},
    {"cull", "lamp", "by the lamp"},
    {"outside_picture", "clamped", "moved inside"},
    {"light.place", "fixed", "at its position"},
    {"light.place", "camera", "at the camera"},
    {"light.model", "lambert", "Lambert"},
    {"light.model", "blinn_phong", "Blinn-Phong"},
    {"light.direction", "to_light", "to the lamp"},
    {"light.direction", "from_light", "from the lamp"},
    {"light.direction", "with_w", "with w = 1"},
    {"light.falloff", "sphere", "4 π r²"},
    {"light.falloff", "no_4pi", "r²"},
    {"light.falloff", "linear", "r"},
    {"light.falloff", "none", "nothing"},
    {"light.falloff", "cubed", "4 π r³"},
    {"light.falloff", "pi_of_atan", "π = atan(1)/4"},
    {"light.falloff", "pi_three", "π = 3"},
    {"light.sum", "reflectance_times", "ρ (D + N)"},
    {"light.sum", "reflectance_plus", "D + ρ"},
    {"light.sum", "reflectance_twice", "ρ ρ (D + N)"},
    {"light.highlight", "unasked", "unlit sides too"},
    {"light.highlight", "long_half", "h too long"},
    {"shadows", "rays", "by rays"},
    {"shadows", "map", "by a map"},
    {"shadow_ray", "to_lamp", "to the lamp"},
    {"shadow_ray", "past_lamp", "past the lamp"},
    {"shadow_filter", "nearest", "the nearest"},
    {"shadow_filter", "four", "four (PCF)"},
    {"bounds", "inside", "from 0 up"},
    {"bounds", "excludes_zero", "above 0"},
    {"encoding", "srgb", "sRGB"},
    {"encoding", "gamma", "c^(1/2.2)"},
    {"colour_over_one", "clamp", "clamped to 1"},
    {"colour_over_one", "wrap", "only the low 8 bits"},
    {"channel_order", "rgb", "red first"},
    {"channel_order", "bgr", "blue first"},
};

} // namespace

std::string choice_words(const Setting& setting, std::string_view word) {
    const auto* const found = std::find_if(
        std::begin(choice_word_list), std::end(choice_word_list), [&](const ChoiceWords& said) {
            return said.word == word && (said.setting.empty() || said.setting == setting.name);
        });
    std::string said(found != std::end(choice_word_list) ? found->said : word);
    std::replace(said.begin(), said.end(), '_', ' ');
    return said;
}

std::string value_words(const Setting& setting, const Settings& settings) {
    const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
    if (choice == nullptr) return value_text(setting, settings);
    const int now = choice->read(settings);
    return now == no_word ? "mixed"
                          : choice_words(setting, choice->words[static_cast<std::size_t>(now)]);
}

} // namespace rasterwalk
