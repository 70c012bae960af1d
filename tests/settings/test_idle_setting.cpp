#include "settings/idle_setting.h"

#include <set>
#include <string>

#include "pipeline/draw.h"
#include "settings/choose_stages.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr std::array all_coverages{Coverage::rows, Coverage::edge_functions,
                                   Coverage::scan_conversion, Coverage::active_edges};

/// Do all words of a choice give the same functions, and the same picture?
bool is_without_effect(const Scene& scene, Settings settings, const ChoiceSetting& choice) {
    choice.write(settings, 0);
    const Framebuffer usual = draw_frame(prepare_frame(scene, settings));
    for (int i = 1; i < static_cast<int>(choice.words.size()); ++i) {
        choice.write(settings, i);
        if (!(draw_frame(prepare_frame(scene, settings)) == usual)) return false;
    }
    return true;
}

} // namespace

TEST_CASE("A setting reported as idle changes no picture, and one that acts is not reported") {
    const Scene scene = small_scene();
    std::set<std::string> idle_somewhere;
    for (const Coverage coverage : all_coverages) {
        for (const Stage stage : {Stage::edges, Stage::rows, Stage::fill, Stage::depth}) {
            Settings settings = default_settings(scene);
            settings.coverage = coverage;
            settings.stage = stage;
            for (const Setting& setting : setting_table()) {
                const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
                if (choice == nullptr || setting.group != "Rows and edges") continue;
                const std::string reason = idle_reason(setting, settings);
                if (reason.empty()) continue;
                idle_somewhere.insert(std::string(setting.name));
                CAPTURE(std::string(setting.name), std::string(word_of(coverage)),
                        static_cast<int>(stage), reason);
                CHECK(is_without_effect(scene, settings, *choice));
            }
        }
    }
    CHECK(idle_somewhere ==
          std::set<std::string>{"line_rounding", "fill_rule", "snap", "pixel_sample", "box_walk",
                                "weight_edge", "line", "bresenham_rule", "line_walk", "sample_rule",
                                "edge_samples", "row_start", "row_search", "empty_rows", "spans"});
    // Each of the rules visible in the tiny picture acts unless it is reported as idle.
    for (const char* const name : {"fill_rule", "pixel_sample", "line", "edge_samples", "spans"}) {
        const Setting& setting = *find_setting(name);
        for (const Coverage coverage : all_coverages) {
            Settings settings = default_settings(scene);
            settings.coverage = coverage;
            settings.stage = Stage::fill;
            CAPTURE(name, std::string(word_of(coverage)));
            CHECK(is_without_effect(scene, settings, std::get<ChoiceSetting>(setting.kind)) ==
                  !idle_reason(setting, settings).empty());
        }
    }
}

TEST_CASE("An idle setting says what makes it idle") {
    Settings settings;
    settings.stage = Stage::fill;
    CHECK(idle_reason(*find_setting("fill_rule"), settings) ==
          "while pixels are found by the row table");
    CHECK(idle_reason(*find_setting("spans"), settings).empty());
    settings.coverage = Coverage::edge_functions;
    CHECK(idle_reason(*find_setting("spans"), settings) ==
          "while pixels are found by edge functions");
    CHECK(idle_reason(*find_setting("fill_rule"), settings).empty());
    settings.stage = Stage::edges;
    CHECK(idle_reason(*find_setting("fill_rule"), settings) == "before the Rows stage");
    CHECK(idle_reason(*find_setting("line"), settings).empty());
}

TEST_CASE("Mistakes of the lab's lines are idle with matrices or a different projection") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    settings.stage = Stage::depth;
    settings.viewport = {50, 50};
    settings.camera.focal_length = 50.0f;
    settings.camera.yaw = 0.1f;
    const auto check = [&](const char* name, const std::string& reason) {
        const Setting& setting = *find_setting(name);
        CAPTURE(name, reason);
        CHECK(idle_reason(setting, settings) == reason);
        CHECK(is_without_effect(room, settings, std::get<ChoiceSetting>(setting.kind)) ==
              !reason.empty());
    };
    check("camera_move", "");
    check("divided_by", "");
    settings.projection_mix = 0.5f;
    check("camera_move", "");
    check("divided_by", "unless the projection is perspective");
    settings.transform = Transform::matrices;
    for (const float mix : {0.0f, 0.5f}) {
        settings.projection_mix = mix;
        check("camera_move", "while transform is matrices");
        check("divided_by", "while transform is matrices");
    }
}

TEST_CASE("With a flashlight the lamp's position is idle, and changes no picture") {
    const Setting& position = *find_setting("light.position");
    Scene scene;
    scene.mesh.add_triangle_of({Vertex{{-1.0f, -1.0f, 1.0f}, {0.0f, 0.0f, -1.0f}},
                                Vertex{{1.0f, -1.0f, 1.0f}, {0.0f, 0.0f, -1.0f}},
                                Vertex{{-1.0f, 1.0f, 2.0f}, {0.0f, 0.0f, -1.0f}}});
    scene.parts.push_back({"wall", 0, 1});
    scene.viewport = {20, 20};
    scene.camera = {{0.0f, 0.0f, -1.0f}, 0.0f, 0.0f, 20.0f};
    Settings settings = default_settings(scene);
    settings.light.power = glm::vec3(14.0f);
    for (const LampPlace place : {LampPlace::fixed, LampPlace::camera}) {
        settings.light.place = place;
        Settings moved = settings;
        moved.light.position = {0.3f, 0.4f, 0.0f};
        const bool is_idle = !idle_reason(position, settings).empty();
        CAPTURE(std::string(word_of(place)));
        CHECK(is_idle == (place == LampPlace::camera));
        CHECK((draw_frame(prepare_frame(scene, settings)) ==
               draw_frame(prepare_frame(scene, moved))) == is_idle);
    }
    CHECK(idle_reason(position, settings) == "while the lamp is at the camera");
}

TEST_CASE("A box replaces the focal length and d, and acts only with matrices") {
    const Scene room = lab_room();
    const auto picture = [&](const Settings& settings) {
        return draw_frame(prepare_frame(room, settings)).colour;
    };
    for (const char* transform : {"transform=lab", "transform=matrices"}) {
        for (const char* box : {"view_box=auto", "view_box=-0.02,0.03,-0.01,0.02"}) {
            Settings settings = default_settings(room);
            for (const char* set : {"viewport.size=60x60", "camera.focal_length=60",
                                    "projection=orthographic", transform, box})
                set_from_text(settings, set);
            for (const auto& [name, value] :
                 {std::pair("camera.focal_length", "40"), std::pair("orthographic_depth", "2"),
                  std::pair("view_box", "-1,2,-1,1")}) {
                Settings other = settings;
                const Setting& setting = *find_setting(name);
                set_value(other, setting, value);
                CAPTURE(transform, box, name);
                CHECK((picture(other) == picture(settings)) ==
                      !idle_reason(setting, settings).empty());
            }
        }
    }
}
