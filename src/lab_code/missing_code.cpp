#include "lab_code/missing_code.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "lab_code/code_words.h"
#include "mistakes/depth_test.h"
#include "settings/idle_setting.h"
#include "settings/stage_functions.h"
#include "settings/value_words.h"
#include "stages/active_edges.h"
#include "stages/fill_rule.h"
#include "stages/scan_conversion.h"

namespace rasterwalk {

namespace {

/// Settings whose values the program is given, and those that change nothing it draws.
constexpr std::array given_settings{
    std::string_view("stage"),
    std::string_view("shading"),
    std::string_view("engine"),
    std::string_view("ray_boxes"),
    std::string_view("mirrors"),
    std::string_view("tessellation"),
    std::string_view("draw_order"),
    std::string_view("painter_rule"),
    std::string_view("bsp_rule"),
    std::string_view("rounding"), // its parts are settings too
    std::string_view("interpolation_mix"),
    std::string_view("camera.position"),
    std::string_view("camera.yaw"),
    std::string_view("camera.pitch"),
    std::string_view("camera.focal_length"),
    std::string_view("camera.aim"),
    std::string_view("camera.target"),
    std::string_view("camera.up"),
    std::string_view("depth_clear"),
    std::string_view("depth_epsilon"),
    std::string_view("surface.alpha"),
    std::string_view("samples"), // their functions are asked for
    std::string_view("supersample"),
    std::string_view("near"),
    std::string_view("far"),
    std::string_view("matrix_order"), // only how it is written down
    std::string_view("projection"),
    std::string_view("projection_mix"),
    std::string_view("orthographic_depth"),
    std::string_view("depth_format"),
    std::string_view("light.position"),
    std::string_view("light.power"),
    std::string_view("light.indirect"),
    std::string_view("light.place"),
    std::string_view("light.model"),
    std::string_view("light.exponent"),
    std::string_view("viewport.size"),
    std::string_view("texture"),
    std::string_view("texture_filter"),
    std::string_view("texture_wrap"),
    std::string_view("texture_alpha"),
    std::string_view("texel_rule"),
    std::string_view("normal_map"),
    std::string_view("normal_map_rule"),
    std::string_view("normal_map_space"),
    std::string_view("parallax"),
    std::string_view("parallax_rule"),
    std::string_view("shadows"),
    std::string_view("shadow_offset"),
    std::string_view("shadow_resolution"),
    std::string_view("shadow_bias"),
    std::string_view("shadow_slope_bias"),
};

bool is_given(std::string_view name) {
    return std::find(given_settings.begin(), given_settings.end(), name) != given_settings.end();
}

bool knows(const LabCode& code, std::string_view word) {
    return code.words.find(word) != code.words.end();
}

std::string words_of_setting(const Setting& setting, const Settings& settings) {
    return fmt::format("{}: {}", setting.title, value_words(setting, settings));
}

/// Is a mistake's function in the slot?
bool has_mistake(const Frame& frame, std::string_view slot) {
    const std::vector<const StageFunction*> used = functions_in_use(frame.settings, frame.scene);
    return std::any_of(used.begin(), used.end(), [&](const StageFunction* row) {
        return row->does.slot == slot && row->file.starts_with("mistakes/");
    });
}

/// Is 1/z, as a float, what the depth buffer holds?
bool has_labs_depths(const Frame& frame) {
    return depth_kind(frame) == ClipDepth::inv_z && depth_bits(frame) == 0;
}

/// Does clipping need double somewhere?
bool has_far_corners(const Frame& frame) {
    return cuts_polygons(frame) &&
           std::any_of(frame.shaded.begin(), frame.shaded.end(), is_too_large_for_float);
}

/// What casts shadows is whole; the program has only the triangles that are drawn.
bool draws_cut_triangles(const Frame& frame) {
    return frame.scene->triangle_count() != frame.in_order->triangle_count();
}

/// Are the rows of a polygon found by following its edges down?
bool walks_down_edges(const Stages& stages) {
    return stages.compute_polygon_rows == rows_by_scan_conversion ||
           stages.compute_polygon_rows == rows_by_active_edges;
}

/// Does Warnock's algorithm draw triangles of one colour each, by the lab's rows?
bool draws_plain_squares(const Frame& frame) {
    constexpr std::array slots{
        std::string_view("row_fragments"), std::string_view("row_pixel_count"),
        std::string_view("drawn_pixels"),  std::string_view("span_end"),
        std::string_view("drawn_area"),    std::string_view("line_step"),
    };
    const bool is_plain = shading_rule(frame.settings) == Shading::unlit && !reads_maps(frame) &&
                          !shows_transparency(frame) && !has_own_corners(frame);
    return is_plain && walks_edges(frame.stages) && !frame.has_samples() &&
           has_labs_depths(frame) && !culls_fragments(frame) &&
           std::none_of(slots.begin(), slots.end(),
                        [&](std::string_view slot) { return has_mistake(frame, slot); });
}

/// What the scene has that settings do not name.
std::string missing_of_scene(const LabCode& code, const Frame& frame) {
    struct Part {
        bool is_there;
        std::string_view word, name;
    };
    const Part parts[] = {
        {is_textured(frame), "scene_textures", "textures"},
        {is_textured(frame) && has_texture_alpha(*frame.scene) &&
             frame.settings.texture_alpha != TextureAlpha::off,
         "texture_alpha", "textures with holes"},
        {shows_transparency(frame), "scene_transparency", "half-transparent surfaces"},
        {frame.bends, "scene_normal_maps", "normal maps"},
        {frame.shifts, "scene_height_maps", "height maps"},
        {occluders_of(frame) != nullptr, "scene_shadows", "shadows"},
        {occluders_of(frame) != nullptr && draws_cut_triangles(frame), "cut_shadows",
         "shadows of triangles that are cut"},
        {shows_highlights(frame), "light_model_blinn_phong", "highlights"},
        {frame.squares != nullptr && !draws_plain_squares(frame), "squares_of_more",
         "Warnock's squares with more than plain colours"},
        {walks_down_edges(frame.stages) && frame.stages.edge_owns_points != owns_top_left &&
             std::any_of(frame.polygons.begin(), frame.polygons.end(),
                         [](const Polygon& polygon) { return polygon.is_cut; }),
         "cut_scan_conversion", "clipped polygons, row by row, without the top-left rule"},
        // A program that writes outside its array has no result.
        {frame.stages.depth_cell == depth_cell_transposed &&
             frame.settings.viewport.width != frame.settings.viewport.height,
         "oblong_depth_index", "[x][y] of a picture that is not square"},
        {frame.stages.depth_cell == depth_cell_transposed &&
             (frame.stages.depth_test != depth_test || !has_labs_depths(frame)) &&
             frame.stages.depth_test != no_depth_test,
         "unusual_depth_index", "[x][y] and another depth test"},
        {has_mistake(frame, "depth_test") && !has_labs_depths(frame), "mistaken_depths",
         "a mistake of the depth test with another depth"},
        {cuts_polygons(frame) && depth_kind(frame) != ClipDepth::inv_z &&
             has_mistake(frame, "clip"),
         "mistaken_cuts_of_depths", "a mistake of clipping with another depth"},
        {frame.has_samples() && coverage_rule(frame.settings) != Coverage::edge_functions,
         "sampled_spans", "samples without edge functions"},
        {frame.has_samples() &&
             (!has_labs_depths(frame) || frame.stages.depth_test == depth_test_linear_z ||
              frame.stages.depth_cell == depth_cell_transposed),
         "sampled_depths", "samples with another depth"},
        {has_far_corners(frame), "far_corners", "clipping of corners that are far away"},
        {leaves_more_corners(frame) && frame.has_samples(), "sampled_fans",
         "samples of polygons that are cut"},
    };
    for (const Part& part : parts) {
        if (part.is_there && !knows(code, part.word)) return std::string(part.name);
    }
    return {};
}

/// Is the work of this slot done before the program or after it? Before: triangles are put in
/// order, and the program is given them so. After: the screen makes bytes of colours.
bool is_outside_program(std::string_view slot) {
    constexpr std::array slots{
        std::string_view("painter_depth"),   std::string_view("is_drawn_before"),
        std::string_view("is_near_side"),    std::string_view("arrange"),
        std::string_view("encode"),          std::string_view("to_byte"),
        std::string_view("visible_channel"),
    };
    return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

/// Is the function in this slot called in such a stage?
bool reaches(std::string_view slot, Stage stage) {
    constexpr std::array of_light{
        std::string_view("pixel_shader"),   std::string_view("reflected_light"),
        std::string_view("light_normal"),   std::string_view("light_side"),
        std::string_view("unit_normal"),    std::string_view("highlight"),
        std::string_view("arrow_of_texel"), std::string_view("tangent_frame"),
        std::string_view("light_space"),    std::string_view("shadow"),
        std::string_view("shadow_ray"),     std::string_view("shadow_texels"),
        std::string_view("parallax_step"),
    };
    const bool is_of_light = std::find(of_light.begin(), of_light.end(), slot) != of_light.end();
    constexpr std::array of_fragments{
        std::string_view("sample_texture"), std::string_view("wrap_texel"),
        std::string_view("texel_place"),    std::string_view("read_texel"),
        std::string_view("texture_level"),  std::string_view("blend"),
    };
    const bool is_of_fragments =
        std::find(of_fragments.begin(), of_fragments.end(), slot) != of_fragments.end();
    return stage == Stage::shade || !(is_of_light || (is_of_fragments && !has_fragments(stage)));
}

/// Stage functions in use that no condition asks for.
std::string missing_function(const LabCode& code, const Frame& frame) {
    for (const StageFunction* const row : functions_in_use(frame.settings, frame.scene)) {
        // What a surface's shader does beyond the lab's is asked of the scene, see above.
        if (row->does.function == "surface_shader") continue;
        // Then nothing is half transparent, see above too.
        if (row->does.function == "blend_nothing") continue;
        if (is_outside_program(row->does.slot)) continue;
        if (!reaches(row->does.slot, frame.settings.stage)) continue;
        const bool is_known = knows(code, row->does.function) ||
                              knows(code, word_of_value(row->setting->name, row->word));
        if (!is_known) return words_of_setting(*row->setting, frame.settings);
    }
    return {};
}

/// Settings that are not the usual ones, do something, and are neither given nor asked for.
std::string missing_setting(const LabCode& code, const Frame& frame) {
    const Settings usual;
    for (const Setting& setting : setting_table()) {
        if (is_given(setting.name) || has_same_value(setting, frame.settings, usual) ||
            !is_of_use(setting, *frame.scene, frame.settings) ||
            !idle_reason(setting, frame.settings).empty())
            continue;
        const std::string value = value_text(setting, frame.settings);
        const bool is_chosen_by_functions = !find_functions(setting.name, value).empty();
        if (is_chosen_by_functions || knows(code, word_of_value(setting.name, value))) continue;
        return words_of_setting(setting, frame.settings);
    }
    return {};
}

} // namespace

std::string missing_code(const LabCode& code, const Frame& frame) {
    std::string missing = missing_of_scene(code, frame);
    if (missing.empty()) missing = missing_function(code, frame);
    if (missing.empty() && !knows(code, fmt::format("stage_{}", stage_word(frame.settings))))
        missing = words_of_setting(*find_setting("shading"), frame.settings);
    if (missing.empty()) missing = missing_setting(code, frame);
    return missing;
}

} // namespace rasterwalk
