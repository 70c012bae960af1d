#include "lab_code/code_words.h"

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "mistakes/clip.h"
#include "mistakes/cull.h"
#include "scene/scene.h"
#include "settings/stage_functions.h"

namespace rasterwalk {

namespace {

constexpr std::string_view stage_prefix = "stage_";

/// Does the program keep vertices in clip space: is there more to do there than the division by z?
bool works_in_clip_space(const Frame& frame) {
    return frame.scene->space == SceneSpace::world &&
           (cuts_polygons(frame) || frame.settings.transform == Transform::matrices ||
            depth_kind(frame) != ClipDepth::inv_z);
}

bool is_lit_at_pixels(const Frame& frame) {
    return frame.settings.stage == Stage::shade && shading_rule(frame.settings) == Shading::phong;
}

bool carries_normals(const Frame& frame) {
    return (is_lit_at_pixels(frame) && has_own_corners(frame)) || culls_fragments(frame);
}

bool is_unlit(const Frame& frame) {
    return has_fragments(frame.settings.stage) && shading_rule(frame.settings) == Shading::unlit;
}

bool carries_colours(const Frame& frame) {
    const bool is_seen =
        is_lit_at_pixels(frame) || (is_unlit(frame) && frame.scene->mesh.differences().colours);
    return is_seen && has_own_corners(frame);
}

bool has_vertex_normals(const Frame& frame) {
    const bool is_lit_at_vertices =
        frame.settings.stage == Stage::shade && shading_rule(frame.settings) == Shading::gouraud;
    return is_lit_at_vertices || carries_normals(frame) ||
           frame.stages.cull == cull_by_vertex_normals;
}

bool knows_camera(const Frame& frame) {
    return frame.scene->space == SceneSpace::world || frame.stages.cull != cull_nothing ||
           culls_fragments(frame);
}

/// Does the program ask from where the camera sees a point?
bool asks_sight_ray(const Frame& frame) {
    const bool is_lit_on_both_sides =
        frame.stages.light_side != side_of_normal && shading_rule(frame.settings) != Shading::unlit;
    return is_lit_on_both_sides || culls_fragments(frame) || frame.shifts ||
           shows_highlights(frame) || frame.stages.cull == cull_by_face_normal ||
           frame.stages.cull == cull_by_vertex_normals;
}

struct FrameWord {
    std::string_view word;
    bool (*holds)(const Frame& frame);
};

/// What no setting says alone.
constexpr FrameWord frame_words[]{
    // A lamp that makes highlights makes none where nothing shines.
    {"light_model_blinn_phong", shows_highlights},
    {"scene_transparency", shows_transparency},
    {"scene_textures", reads_maps},
    {"scene_normal_maps", [](const Frame& frame) { return frame.bends; }},
    {"scene_height_maps", [](const Frame& frame) { return frame.shifts; }},
    {"scene_surface_axes", [](const Frame& frame) { return frame.bends || frame.shifts; }},
    {"scene_shadows", [](const Frame& frame) { return occluders_of(frame) != nullptr; }},
    {"scene_corners", has_own_corners},
    {"space_pixels", [](const Frame& f) { return f.scene->space == SceneSpace::pixels; }},
    {"camera_known", knows_camera},
    {"hidden_warnock", [](const Frame& frame) { return frame.squares != nullptr; }},
    {"clip_space", works_in_clip_space},
    {"cuts_polygons", cuts_polygons},
    {"more_corners", leaves_more_corners},
    {"clip_nothing", [](const Frame& frame) { return frame.stages.clip == clip_nothing; }},
    {"projection_mixed", [](const Frame& f) { return vertex_rules(f).projection.mix > 0.0f; }},
    {"asks_sight_ray", asks_sight_ray},
    {"vertex_normals", has_vertex_normals},
    {"carried_pos3d", [](const Frame& f) { return is_lit_at_pixels(f) || culls_fragments(f); }},
    {"carried_normal", carries_normals},
    {"carried_color", carries_colours},
    {"mip_levels", uses_mip_levels},
    {"depth_ndc", [](const Frame& frame) { return depth_kind(frame) == ClipDepth::ndc; }},
    {"depth_reversed", [](const Frame& frame) { return depth_kind(frame) == ClipDepth::reversed; }},
    {"depth_in_16_bits", [](const Frame& frame) { return depth_bits(frame) == 16; }},
    {"depth_in_bits", [](const Frame& frame) { return depth_bits(frame) > 0; }},
};

} // namespace

std::string word_of_value(std::string_view setting, std::string_view value) {
    std::string word = fmt::format("{}_{}", setting, value);
    std::replace(word.begin(), word.end(), '.', '_');
    return word;
}

std::string_view stage_word(const Settings& settings) {
    if (settings.stage != Stage::shade) return stage_info(settings).name;
    switch (shading_rule(settings)) {
    case Shading::unlit:
        return "unlit";
    case Shading::flat:
        return "flat";
    case Shading::gouraud:
        return "vertex_light";
    case Shading::phong:
        break;
    }
    return "pixel_light";
}

bool shows_highlights(const Frame& frame) {
    const std::vector<Vertex>& vertices = frame.scene->mesh.vertices();
    const bool is_shiny = std::any_of(vertices.begin(), vertices.end(), [](const Vertex& vertex) {
        return !(vertex.shine == Vertex{}.shine);
    });
    return is_shiny && frame.settings.stage == Stage::shade &&
           frame.settings.light.model != LightModel::lambert;
}

bool shows_transparency(const Frame& frame) {
    return frame.blends && has_fragments(frame.settings.stage);
}

bool reads_maps(const Frame& frame) {
    return is_textured(frame) || frame.bends || frame.shifts;
}

int depth_bits(const Frame& frame) {
    return depth_rules(frame.settings, frame.scene->space).bits;
}

bool cuts_polygons(const Frame& frame) {
    const bool does_nothing =
        frame.stages.clip == clip_nothing && frame.stages.reject == reject_nothing;
    return !does_nothing && frame.scene->space == SceneSpace::world;
}

bool leaves_more_corners(const Frame& frame) {
    const auto clip = frame.stages.clip;
    return cuts_polygons(frame) && clip != clip_nothing && clip != drop_partly_outside &&
           clip != move_to_near_plane;
}

bool culls_fragments(const Frame& frame) {
    return frame.stages.cull_fragment != keep_fragment;
}

bool has_own_corners(const Frame& frame) {
    const CornerDifferences& differences = frame.scene->mesh.differences();
    const bool is_culled_by_normals = frame.stages.cull == cull_by_face_normal ||
                                      frame.stages.cull == cull_by_vertex_normals ||
                                      frame.stages.cull == cull_by_lamp || culls_fragments(frame);
    if (differences.colours && is_unlit(frame)) return true;
    return (differences.normals || differences.colours) &&
           (frame.settings.stage == Stage::shade || is_culled_by_normals);
}

bool uses_mip_levels(const Frame& frame) {
    const TextureFilter filter = frame.settings.texture_filter;
    const bool takes_copies = filter == TextureFilter::mipmap || filter == TextureFilter::trilinear;
    return takes_copies && reads_maps(frame);
}

bool is_mistake_word(std::string_view word) {
    static const std::set<std::string, std::less<>> words = [] {
        std::set<std::string, std::less<>> all;
        for (const StageFunction& row : stage_functions()) {
            if (row.file.starts_with("mistakes/"))
                all.insert(word_of_value(row.setting->name, row.word));
        }
        return all;
    }();
    return words.find(word) != words.end();
}

bool code_word_holds(std::string_view word, const Frame& frame) {
    const Settings& settings = frame.settings;
    if (word.starts_with(stage_prefix))
        return word.substr(stage_prefix.size()) == stage_word(settings);
    for (const FrameWord& one : frame_words) {
        if (one.word == word) return one.holds(frame);
    }
    for (const StageFunction* const row : functions_in_use(settings, frame.scene)) {
        if (row->does.function == word) return true;
    }
    // If a value chooses functions, but other settings keep them from being called, it says
    // nothing.
    const auto acts = [&](const Setting& setting, std::string_view value) {
        const std::vector<const StageFunction*> rows = find_functions(setting.name, value);
        return rows.empty() || std::any_of(rows.begin(), rows.end(), [&](const StageFunction* row) {
                   return is_chosen(*row, settings, frame.scene);
               });
    };
    const std::span<const Setting> table = setting_table();
    return std::any_of(table.begin(), table.end(), [&](const Setting& setting) {
        const std::string_view name = setting.name;
        // The name first: a value need not be written out for each word and setting.
        const bool is_named =
            word.size() > name.size() + 1 && word[name.size()] == '_' &&
            std::equal(name.begin(), name.end(), word.begin(),
                       [](char a, char b) { return a == b || (a == '.' && b == '_'); });
        if (!is_named) return false;
        const std::string value = value_text(setting, settings);
        return word == word_of_value(name, value) && acts(setting, value);
    });
}

} // namespace rasterwalk
