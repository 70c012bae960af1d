// Every word of every setting: the fast engine draws it as the steps do, or reports that it does
// not support it, or it is a rule for pixels and edges that the engine replaces by its own. A new
// setting fails this test until one of these is chosen for it.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engines/fast/fast_view.h"
#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "scene/scene.h"
#include "settings/setting_table.h"
#include "settings/settings.h"
#include "support/choices.h"
#include "support/fast_pictures.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The settings that the fast engine replaces by its own rules, and why.
const std::map<std::string_view, std::string_view> own_rules{
    {"rounding", "corners stand on 256ths of a pixel"},
    {"vertex_rounding", "corners stand on 256ths of a pixel"},
    {"line_rounding", "edges have no samples"},
    {"coverage", "centres of pixels are asked"},
    {"fill_rule", "the top-left rule"},
    {"snap", "corners stand on 256ths of a pixel"},
    {"box_walk", "the same pixels lie inside, however many are asked"},
    {"line", "edges have no samples"},
    {"bresenham_rule", "edges have no samples"},
    {"line_walk", "edges have no samples"},
    {"edge_samples", "edges have no samples"},
    {"row_start", "there is no row table"},
    {"row_search", "there is no row table"},
    {"empty_rows", "there is no row table"},
    {"spans", "there is no row table"},
    {"behind_mark", "what lies behind the near plane is cut off"},
    {"clip", "what lies behind the near plane is cut off"},
    {"reject", "what lies outside is not drawn, however that is found"},
};

/// Values of each setting that is not a choice of words, different from the default.
const std::map<std::string_view, std::vector<std::string>> other_values{
    {"tessellation", {"1", "3"}},
    {"samples", {"1", "4"}},
    {"supersample", {"1", "2"}},
    {"depth_clear", {"0", "0.34"}},
    {"depth_epsilon", {"0", "0.02"}},
    {"camera.position", {"0.2,0.1,-3.4"}},
    {"camera.yaw", {"0.2"}},
    {"camera.pitch", {"-0.1"}},
    {"camera.focal_length", {"90"}},
    {"camera.target", {"0.2,0.3,0"}},
    {"camera.up", {"0.2,-1,0"}},
    {"projection_mix", {"0", "0.5", "1"}},
    {"interpolation_mix", {"0", "1"}},
    {"orthographic_depth", {"2"}},
    {"near", {"0.5", "2.5"}},
    {"far", {"3.5"}},
    {"light.position", {"0.3,-0.2,-0.6"}},
    {"light.power", {"2,1,0.5"}},
    {"light.indirect", {"0.1,0.2,0.3"}},
    {"light.exponent", {"0", "3.5"}},
    {"surface.alpha", {"0", "0.3"}},
    {"shadow_offset", {"0.1"}},
    {"shadow_resolution", {"16"}},
    {"shadow_bias", {"0.1"}},
    {"shadow_slope_bias", {"2"}},
    {"view_box", {"auto", "-0.1,0.1,0,0.2"}},
    {"viewport.size", {"61x57"}},
};

std::vector<std::string> values_of(const Setting& setting) {
    if (const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind))
        return {choice->words.begin(), choice->words.end()};
    const auto values = other_values.find(setting.name);
    return values == other_values.end() ? std::vector<std::string>{} : values->second;
}

/// A scene, and settings under which what some words do can be seen.
struct Ground {
    Scene scene;
    std::vector<std::string> assignments;
};

/// The room seen so that one of its ends is outside the picture, with highlights and a camera that
/// can be aimed.
std::vector<Ground> grounds() {
    Scene half_clear = lab_room();
    half_clear.parts.back().alpha = 0.5f;
    return {{lab_room(), {}},
            {lab_room(), {"shading=gouraud", "camera.position=0.3,0.2,-1.9", "camera.yaw=0.3"}},
            {lab_room(), {"transform=matrices", "light.power=9,8,7"}},
            {lesson_scene("checkered-room"),
             {"camera.position=0.0137,0.0071,-3", "camera.yaw=0.03", "camera.pitch=0.02"}},
            {lesson_scene("cylinder"), {"camera.position=0.1,-1.6,-4", "light.power=150"}},
            {lesson_scene("beyond-the-texture"), {}},
            {lesson_scene("z-fighting"), {}},
            {lesson_scene("brick-relief"),
             {"normal_map=off", "camera.yaw=0.03", "camera.target=0.0137,0.0071,1"}},
            {lesson_scene("brick-heights"),
             {"normal_map=off", "parallax=off", "camera.position=0,0,0", "camera.yaw=0.03",
              "camera.target=0.0137,0.0071,1"}},
            {half_clear, {"blend=off"}}};
}

Settings settings_of_ground(const Ground& ground) {
    Settings settings = by_fast_rules(default_settings(ground.scene));
    settings.stage = Stage::shade;
    settings.shading = Shading::phong;
    settings.camera.focal_length *= 80.0f / static_cast<float>(settings.viewport.width);
    settings.viewport = {80, 70};
    set_from_text(settings, "shadow_resolution=16");
    for (const std::string& assignment : ground.assignments)
        set_from_text(settings, assignment);
    return settings;
}

enum class Verdict { alike, refused, other };

Verdict verdict_on(const Scene& scene, const Settings& settings) {
    if (!fast_engine_refuses(scene, settings).empty()) return Verdict::refused;
    const Frame frame = prepare_frame(scene, settings);
    const FastDifference found = difference(fast_picture(scene, settings), draw_frame(frame));
    return found.is_small() ? Verdict::alike : Verdict::other;
}

} // namespace

TEST_CASE("Each word of each setting is drawn as by the steps, refused, or a replaced rule") {
    std::set<std::string> drawn, refused;
    for (const Ground& ground : grounds()) {
        const Settings usual = settings_of_ground(ground);
        if (verdict_on(ground.scene, usual) != Verdict::alike) continue;
        for (const Setting& setting : setting_table()) {
            if (own_rules.contains(setting.name)) continue;
            for (const std::string& value : values_of(setting)) {
                Settings settings = usual;
                set_value(settings, setting, value);
                const std::string assignment = std::string(setting.name) + "=" + value;
                CAPTURE(ground.scene.name, assignment);
                const Verdict verdict = verdict_on(ground.scene, settings);
                CHECK(verdict != Verdict::other);
                (verdict == Verdict::refused ? refused : drawn).insert(assignment);
            }
        }
    }
    for (const Setting& setting : setting_table()) {
        if (own_rules.contains(setting.name)) continue;
        CAPTURE(setting.name);
        // A setting that is new to this test.
        CHECK_FALSE(values_of(setting).empty());
    }
    for (const char* assignment :
         {"stage=pixel_light", "stage=vertex_light", "stage=depth", "texture_wrap=mirror",
          "texture_filter=bilinear", "cull=screen_area", "light.model=blinn_phong",
          "light.place=camera", "camera.aim=look_at", "transform=matrices", "near=2.5",
          "view_box=-0.1,0.1,0,0.2"}) // in the lab's way it is idle
        CHECK(drawn.contains(assignment));
    // Not where the row table finds the pixels, which has no samples.
    for (const char* const samples : {"samples=4", "supersample=2"}) {
        Settings settings;
        set_from_text(settings, samples);
        CHECK(fast_engine_refuses(lab_room(), settings).empty());
        set_from_text(settings, "coverage=edge_functions");
        CHECK(fast_engine_refuses(lab_room(), settings) ==
              "the fast engine does not support several samples of a pixel");
    }
    for (const char* assignment :
         {"stage=fill", "shading=flat", "projection=orthographic", "texture_filter=mipmap",
          "cull=face_normal", "shadows=rays", "shadows=map", "depth_test=reversed",
          "light.falloff=cubed", "normal_map=on", "parallax=divided", "parallax=limited",
          "blend=over", "tessellation=3", "depth_format=inv_z_16", "depth_index=transposed",
          "bounds=excludes_zero", "encoding=srgb", "view_box=-0.1,0.1,0,0.2"}) // by matrices
        CHECK(refused.contains(assignment));
    for (const char* mistake :
         {"camera_move=added", "camera_move=rotated_first", "image_axes=exchanged",
          "image_axes=uncentred", "divided_by=distance", "cull=lamp", "light.direction=with_w",
          "light.falloff=pi_of_atan", "light.falloff=pi_three", "light.sum=reflectance_twice",
          "encoding=gamma", "channel_order=bgr"})
        CHECK(refused.contains(mistake));
}

TEST_CASE("A refusal names its setting, and is not a full sentence") {
    const Scene room = lab_room();
    const auto refusal = [&](const char* assignment) {
        Settings settings = settings_of_ground({room, {}});
        set_from_text(settings, assignment);
        return fast_engine_refuses(room, settings);
    };
    CHECK(refusal("shading=phong") == "");
    CHECK(refusal("shading=flat") == "the fast engine does not support shading=flat");
    CHECK(refusal("shadows=map") == "the fast engine does not support shadows");
    CHECK(refusal("projection=orthographic") ==
          "the fast engine does not support any projection except perspective");
    CHECK(refusal("light.falloff=none") ==
          "the fast engine does not support light.falloff other than sphere");
    CHECK(refusal("depth_epsilon=0.1") ==
          "the fast engine does not support depth_epsilon other than 0");
    CHECK(refusal("stage=fill") == "the fast engine does not support stages before depth");
}

TEST_CASE("The rules that the fast engine replaces by its own do not change its picture") {
    const Scene room = lab_room();
    const Settings usual = settings_of_ground({room, {}});
    const FastPicture expected = fast_picture(room, usual);
    for (const auto& [name, why] : own_rules) {
        const Setting* const setting = find_setting(name);
        CAPTURE(name, why);
        REQUIRE(setting != nullptr);
        int drawn = 0;
        for (const std::string& value : values_of(*setting)) {
            Settings settings = usual;
            set_value(settings, *setting, value);
            CAPTURE(value);
            // Mistakes of a rule are refused; every other word of it changes nothing.
            if (!fast_engine_refuses(room, settings).empty()) continue;
            ++drawn;
            CHECK(first_other_bits(expected, fast_picture(room, settings)) == "");
        }
        CHECK(drawn >= 2);
    }
}
