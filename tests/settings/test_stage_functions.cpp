#include "settings/stage_functions.h"

#include <array>
#include <set>
#include <string>

#include "base/files.h"
#include "mistakes/coverage.h"
#include "mistakes/light.h"
#include "mistakes/vertex_shader.h"
#include "settings/choose_stages.h"
#include "stages/orthographic.h"
#include "stages/surface_shader.h"
#include "support/project_root.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Settings lab_with(std::initializer_list<const char*> assignments) {
    Settings settings;
    for (const char* const assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

/// The lab's rules, and others without which some words do nothing.
const std::vector<Settings>& rules_to_start_from() {
    static const std::vector<Settings> all{lab_with({}),
                                           lab_with({"transform=matrices"}),
                                           lab_with({"line=bresenham"}),
                                           lab_with({"coverage=edge_functions"}),
                                           lab_with({"coverage=scan_conversion"}),
                                           lab_with({"coverage=edge_functions", "samples=4"}),
                                           lab_with({"depth_test=off"}),
                                           lab_with({"depth_format=ndc_16"})};
    return all;
}

/// Does the word, in place of the usual one, change a stage under any of these rules?
bool changes_a_stage(const Setting& setting, std::string_view word) {
    for (const Settings& before : rules_to_start_from()) {
        if (!has_same_value(setting, before, Settings{})) continue;
        Settings after = before;
        set_value(after, setting, word);
        if (choose_stages(after) != choose_stages(before)) return true;
    }
    return false;
}

/// A triangle whose corners may differ in normal and colour.
Scene one_triangle(bool normals_differ, bool colours_differ) {
    std::array<Vertex, triangle_corners> corners{};
    corners[1].position.x = corners[2].position.y = 1.0f;
    for (Vertex& corner : corners)
        corner.normal = {0.0f, 0.0f, -1.0f};
    if (normals_differ) corners[1].normal = {1.0f, 0.0f, 0.0f};
    if (colours_differ) corners[1].reflectance = {1.0f, 0.0f, 0.0f};
    Scene scene;
    scene.mesh.add_triangle_of(corners);
    return scene;
}

/// "slot function", of all that is in use.
std::vector<std::string> used(const Settings& settings, const Scene* scene = nullptr) {
    std::vector<std::string> all;
    for (const StageFunction* const row : functions_in_use(settings, scene))
        all.push_back(std::string(row->does.slot).append(" ").append(row->does.function));
    return all;
}

} // namespace

TEST_CASE("The file of each row of the registry declares its function") {
    for (const StageFunction& row : stage_functions()) {
        const std::string name(row.does.function);
        CAPTURE(name, std::string(row.file));
        const std::string text = read_file(project_root() + "/src/" + std::string(row.file));
        bool is_declared = false;
        for (std::size_t at = text.find(name + "("); at != std::string::npos;
             at = text.find(name + "(", at + 1)) {
            // A declaration begins its line with a type, and the name is a word of its own.
            const char first = text[text.rfind('\n', at) + 1];
            const bool is_word = text[at - 1] == ' ';
            if (is_word && first != ' ' && first != '/') is_declared = true;
        }
        CHECK(is_declared);
    }
}

TEST_CASE("A word has a row of the registry if and only if it changes a stage") {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr) continue;
        for (const std::string_view word : choice->words) {
            CAPTURE(std::string(setting.name), std::string(word));
            bool has_row = false;
            for (const StageFunction* const row : find_functions(setting.name, word)) {
                // That shader also takes a scene.
                if (row->does.slot != "pixel_shader") has_row = true;
            }
            CHECK(has_row == changes_a_stage(setting, word));
        }
    }
}

TEST_CASE("Each row of the registry is in use under some settings") {
    std::set<const StageFunction*> in_use;
    for (const Settings& rules : rules_to_start_from()) {
        for (const StageFunction& row : stage_functions()) {
            Settings settings = rules;
            settings.stage = Stage::shade;
            const auto* const whole = std::get_if<WholeSetting>(&row.setting->kind);
            const std::string number = whole != nullptr ? std::to_string(whole->largest) : "0.5";
            set_value(settings, *row.setting, row.word.empty() ? number : std::string(row.word));
            Scene scene = one_triangle(true, true);
            scene.parts.emplace_back().normal_map = 0;
            const auto found = functions_in_use(settings, &scene);
            in_use.insert(found.begin(), found.end());
        }
    }
    for (const StageFunction& row : stage_functions()) {
        CAPTURE(std::string(row.setting->name), std::string(row.word),
                std::string(row.does.function));
        CHECK(in_use.contains(&row));
    }
}

TEST_CASE("A row of the registry is found by its setting and its word") {
    const auto rows = find_functions("clip", "near");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0]->does.slot == "is_in_front");
    CHECK(rows[0]->does.function == "has_positive_w");
    CHECK(rows[1]->does.function == "clip_near");
    CHECK(rows[1]->file == "stages/clip.h");
    CHECK(find_functions("cull").size() == 6);
    CHECK(find_functions("cull", "none").empty());
    CHECK(find_functions("matrix_order").empty());
    CHECK(find_functions("no such setting").empty());
}

TEST_CASE("The functions in use are those that no later row has replaced") {
    using Names = std::vector<std::string>;
    CHECK(used({}).empty());
    CHECK(used(lab_with({"line=bresenham", "bresenham_rule=wrong_term"})) ==
          Names{"line line_by_wrong_term"});
    CHECK(used(lab_with({"depth_format=inv_z_16", "depth_epsilon=0.1"})) ==
          Names{"depth_test depth_test_with_epsilon"});
    CHECK(used(lab_with({"depth_test=linear_z", "stage=fill"})) ==
          Names{"depth_test no_depth_test"});
    CHECK(
        used(lab_with({"coverage=edge_functions", "line_walk=zinv_falls", "spans=last_dropped"})) ==
        Names{"compute_polygon_rows rows_by_edge_functions", "polygon_box snapped_box",
              "row_fragments fragments_by_weights"});
    CHECK(used(lab_with({"light.falloff=cubed", "light.sum=reflectance_plus"})) ==
          Names{"reflected_light cubed_area", "reflected_light reflectance_plus"});
}

TEST_CASE("A function made of parts has the part of each setting") {
    CHECK(choose_stages(lab_with({"light.direction=from_light", "light.falloff=cubed",
                                  "light.sum=reflectance_twice"}))
              .reflected_light ==
          mistaken_light<vector_from_lamp, own_square, own_length, cubed_area, reflectance_twice>);
    CHECK(choose_stages(lab_with({"light.direction=with_w", "light.falloff=pi_three"}))
              .reflected_light == mistaken_light<vector_to_lamp, square_with_w, own_length,
                                                 area_with_pi_three, reflectance_times>);
    CHECK(
        choose_stages(lab_with({"light.direction=not_normalized"})).reflected_light ==
        mistaken_light<vector_to_lamp, own_square, not_normalized, sphere_area, reflectance_times>);
    CHECK(choose_stages(lab_with({"image_axes=mirrored", "divided_by=distance"})).to_clip_space ==
          to_clip_space_with<axes_mirrored, to_clip_space_by_distance<to_clip_space>>);
    CHECK(choose_stages(lab_with({"image_axes=exchanged", "projection_mix=0.5"})).to_clip_space ==
          to_clip_space_with<axes_exchanged, to_clip_space_mixed>);
    CHECK(choose_stages(lab_with({"divided_by=distance", "projection_mix=0.5"})).to_clip_space ==
          to_clip_space_mixed);
    CHECK(choose_stages(lab_with({"transform=matrices", "rotation=transposed"})).vertex_shader ==
          mistaken_matrices<true, axes_kept>);
    CHECK(choose_stages(lab_with({"transform=matrices", "image_axes=exchanged"})).vertex_shader ==
          mistaken_matrices<false, axes_exchanged>);
    CHECK(
        choose_stages(lab_with({"coverage=edge_functions", "snap=subpixel", "pixel_sample=corner"}))
            .snap == snap_for_corners<snap_to_subpixel>);
}

TEST_CASE("The lab's pixel shader stays unless a scene needs another") {
    const Scene plain = one_triangle(false, false), coloured = one_triangle(false, true);
    CHECK(choose_stages({}, plain) == Stages{});
    CHECK(choose_stages(lab_with({"shading=flat"})).pixel_shader == pixel_shader);
    CHECK(choose_stages(lab_with({"shading=flat"}), plain).pixel_shader == surface_shader);
    CHECK(choose_stages(lab_with({"shading=gouraud"}), coloured).pixel_shader == pixel_shader);
    // Before the last stage nothing is lit, and colours are seen.
    const Stages early = choose_stages(lab_with({"shading=gouraud", "stage=fill"}), coloured);
    CHECK(early.pixel_shader == surface_shader);
    CHECK(early.varyings_read == varyings_read_by_surfaces<false, true>);
    CHECK(choose_stages({}, one_triangle(true, false)).varyings_read ==
          varyings_read_by_surfaces<true, false>);
}
