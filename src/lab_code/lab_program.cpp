#include "lab_code/lab_program.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "base/files.h"
#include "scene/scene.h"
#include "settings/idle_setting.h"
#include "settings/stage_functions.h"
#include "settings/value_words.h"

namespace rasterwalk {

namespace {

constexpr std::string_view stage_prefix = "stage_";

/// How far a frame is drawn, as conditions call it.
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

/// A setting and a value as a condition writes them: "light_falloff_linear".
std::string word_of_value(std::string_view setting, std::string_view value) {
    std::string word = fmt::format("{}_{}", setting, value);
    std::replace(word.begin(), word.end(), '.', '_');
    return word;
}

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
    std::string_view("near"),
    std::string_view("far"),
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

bool shows_highlights(const Frame& frame) {
    const std::vector<Vertex>& vertices = frame.scene->mesh.vertices();
    const bool is_shiny = std::any_of(vertices.begin(), vertices.end(), [](const Vertex& vertex) {
        return !(vertex.shine == Vertex{}.shine);
    });
    return is_shiny && frame.settings.stage == Stage::shade &&
           frame.settings.light.model != LightModel::lambert;
}

/// Does a word of a condition name a mistake?
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
        {frame.blends && has_fragments(frame.settings.stage), "scene_transparency",
         "half-transparent surfaces"},
        {has_own_corners(frame) && frame.stages.cull == cull_by_face_normal, "culled_corners",
         "culling curved surfaces"},
        {frame.bends, "scene_normal_maps", "normal maps"},
        {frame.shifts, "scene_height_maps", "height maps"},
        {occluders_of(frame) != nullptr, "scene_shadows", "shadows"},
        {frame.pass < 0, "scene_shadow_map", "the faces of a shadow map"},
        {shows_highlights(frame), "light_model_blinn_phong", "highlights"},
        {frame.squares != nullptr, "hidden_warnock", "Warnock's squares"},
    };
    for (const Part& part : parts) {
        if (part.is_there && !knows(code, part.word)) return std::string(part.name);
    }
    return {};
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

const std::vector<std::string>& lab_file_names() {
    static const std::vector<std::string> names{
        "types.cpp",          "put_pixel.cpp",   "light.cpp", "vertex_shader.cpp", "texture.cpp",
        "pixel_shader.cpp",   "interpolate.cpp", "lines.cpp", "edges.cpp",         "rows.cpp",
        "edge_functions.cpp", "row_ends.cpp",    "fill.cpp",  "draw.cpp"};
    return names;
}

LabCode read_lab_code(const std::string& folder) {
    LabCode code;
    const CodeWords note_words{[&](std::string_view word) {
                                   code.words.emplace(word);
                                   return false;
                               },
                               [](std::string_view) { return false; }};
    for (const std::string& name : lab_file_names()) {
        const std::string path = folder + "/" + name;
        code.files.push_back({name, read_file(path)});
        std::vector<ChosenLine> ignored;
        choose_lines(code.files.back().text, path, 0, note_words, ignored);
    }
    return code;
}

bool has_own_corners(const Frame& frame) {
    const CornerDifferences& differences = frame.scene->mesh.differences();
    return frame.settings.stage == Stage::shade && (differences.normals || differences.colours);
}

bool code_word_holds(std::string_view word, const Frame& frame) {
    const Settings& settings = frame.settings;
    if (word.starts_with(stage_prefix))
        return word.substr(stage_prefix.size()) == stage_word(settings);
    // A lamp that makes highlights makes none where nothing shines.
    if (word == "light_model_blinn_phong") return shows_highlights(frame);
    if (word == "scene_transparency") return frame.blends && has_fragments(frame.settings.stage);
    if (word == "scene_textures") return is_textured(frame);
    if (word == "scene_corners") return has_own_corners(frame);
    if (word == "space_pixels") return frame.scene->space == SceneSpace::pixels;
    for (const StageFunction* const row : functions_in_use(settings, frame.scene)) {
        if (row->does.function == word) return true;
    }
    const std::span<const Setting> table = setting_table();
    return std::any_of(table.begin(), table.end(), [&](const Setting& setting) {
        const std::string_view name = setting.name;
        // The name first: a value need not be written out for each word and setting.
        const bool is_named =
            word.size() > name.size() + 1 && word[name.size()] == '_' &&
            std::equal(name.begin(), name.end(), word.begin(),
                       [](char a, char b) { return a == b || (a == '.' && b == '_'); });
        return is_named && word == word_of_value(name, value_text(setting, settings));
    });
}

std::vector<ChosenLine> lines_for(const LabCode& code, const Frame& frame) {
    std::vector<ChosenLine> lines;
    std::map<std::string, bool, std::less<>> known; // most words are asked for several times
    const CodeWords words{
        [&](std::string_view word) {
            const auto found = known.find(word);
            if (found != known.end()) return found->second;
            return known.emplace(std::string(word), code_word_holds(word, frame)).first->second;
        },
        is_mistake_word};
    for (std::size_t i = 0; i < code.files.size(); ++i) {
        const std::size_t before = lines.size();
        choose_lines(code.files[i].text, code.files[i].name, static_cast<int>(i), words, lines);
        // A line between files, which shows where one ends.
        const bool has_lines = lines.size() > before;
        if (has_lines && before > 0)
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(before),
                         ChosenLine{{}, static_cast<int>(i), 0, {}});
    }
    return lines;
}

std::string missing_code(const LabCode& code, const Frame& frame) {
    std::string missing = missing_of_scene(code, frame);
    if (missing.empty()) missing = missing_function(code, frame);
    if (missing.empty() && !knows(code, fmt::format("stage_{}", stage_word(frame.settings))))
        missing = words_of_setting(*find_setting("shading"), frame.settings);
    if (missing.empty()) missing = missing_setting(code, frame);
    return missing;
}

FileLines file_around(const std::vector<ChosenLine>& lines, int line) {
    const auto size = static_cast<int>(lines.size());
    const auto at = [&](int number) -> const ChosenLine& {
        return lines[static_cast<std::size_t>(number - 1)];
    };
    line = std::clamp(line, 1, size);
    FileLines found{at(line).file, line, line};
    // The empty line between two files belongs to neither.
    while (found.first > 1 && at(found.first - 1).file == found.file &&
           at(found.first - 1).line > 0)
        --found.first;
    while (found.last < size && at(found.last + 1).file == found.file)
        ++found.last;
    return found;
}

std::string_view shown_words(std::string_view line) {
    line = line.substr(0, line.find("//@"));
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

std::string source_text(const std::vector<ChosenLine>& lines, Viewport picture) {
    std::string text;
    for (const ChosenLine& line : lines) {
        if (line.text.starts_with("const int SCREEN_WIDTH"))
            text += fmt::format("const int SCREEN_WIDTH = {};", picture.width);
        else if (line.text.starts_with("const int SCREEN_HEIGHT"))
            text += fmt::format("const int SCREEN_HEIGHT = {};", picture.height);
        else
            text += line.text;
        text += '\n';
    }
    return text;
}

} // namespace rasterwalk
