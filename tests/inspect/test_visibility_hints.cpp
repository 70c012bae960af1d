// The counts on the picture of a model, compared with rays in double; and the settings named.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "inspect/visibility_hints.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/choices.h"
#include "support/hinted_models.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {
namespace visibility_hints_of_models {

Settings settings_of(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

std::vector<VisibilityHint> hints_of(const Scene& scene,
                                     const std::vector<std::string>& assignments) {
    const Frame frame = prepare_frame(scene, settings_of(scene, assignments));
    return visibility_hints(frame, draw_frame(frame));
}

/// The same counts from the corners of the scene in double, and from the planes.
VisiblePixels counted_otherwise(const Scene& scene, const Settings& settings) {
    const Framebuffer picture = draw_frame(prepare_frame(scene, settings));
    VisiblePixels visible;
    for (std::size_t i = 0; i < picture.owner.size(); ++i) {
        const int t = picture.owner[i];
        if (t < 0) continue;
        const auto place = [&](int c) { return glm::dvec3(scene.corner(t, c).position); };
        // Corners of a front go round clockwise, y down: their cross product points to the eye.
        const glm::dvec3 across = glm::cross(place(2) - place(0), place(1) - place(0));
        ++visible.surface;
        visible.backs += glm::dot(across, place(0) - glm::dvec3(settings.camera.position)) > 0.0;
        // Bytes are rounded here, not truncated.
        const glm::vec3& c = picture.colour[i];
        const long byte = std::lround(255.0f * std::min(std::max({c.r, c.g, c.b}), 1.0f));
        visible.lit += byte > 0;
        visible.light += byte;
    }
    return visible;
}

} // namespace visibility_hints_of_models
} // namespace

TEST_CASE("Back faces and black pixels are counted over the picture") {
    using namespace visibility_hints_of_models;
    for (const Scene& scene : {box(true), box(false), sheet(true), sheet(false)}) {
        for (const char* light : {"light.indirect=0", "light.indirect=0.2"}) {
            const Settings settings = settings_of(scene, {light});
            const Frame frame = prepare_frame(scene, settings);
            const VisiblePixels visible = count_visible(frame, draw_frame(frame));
            CHECK(visible == counted_otherwise(scene, settings));
            CHECK(visible.surface > 1000);
        }
    }
}

TEST_CASE("A box whose fronts point inward is reported as seen from behind, and no other") {
    using namespace visibility_hints_of_models;
    const std::vector<VisibilityHint> hints = hints_of(box(true), {});
    REQUIRE(hints.size() == 2);
    CHECK_THAT(hints[0].finding, StartsWith("Most of what you see is back faces, "));
    CHECK(hints[0].settings == std::vector<std::string>{"cull=face_normal"});
    CHECK(hints[1].finding == hints[0].finding);
    CHECK(hints[1].settings == std::vector<std::string>{"light.sides=two"});
    // After either of them, neither is left.
    CHECK(hints_of(box(true), {"light.sides=two"}).empty());
    CHECK(hints_of(box(true), {"cull=face_normal"}).empty());
    CHECK(hints_of(box(true), {"stage=rows"}).empty());
    CHECK(hints_of(box(false), {}).empty());
    // Nothing is behind a sheet, but its back can be lit.
    const std::vector<VisibilityHint> back = hints_of(sheet(true), {});
    REQUIRE(back.size() == 1);
    CHECK(back[0].settings == std::vector<std::string>{"light.sides=two"});
    CHECK(hints_of(sheet(true), {"shading=unlit"}).empty());
    CHECK(hints_of(sheet(false), {}).empty());
    // The lab's picture is taken as intended.
    CHECK(hints_of(test::lesson_scene("lab-room"), {"light.indirect=0", "light.power=0"}).empty());
}

TEST_CASE("If all is black the hint names the setting that lights most of it, or none") {
    using namespace visibility_hints_of_models;
    const std::vector<VisibilityHint> back = hints_of(sheet(true), {"light.indirect=0"});
    REQUIRE(back.size() == 1);
    CHECK(back[0].finding == "Everything you see is black");
    CHECK(back[0].settings == std::vector<std::string>{"light.sides=two"});
    CHECK_THAT(back[0].help, StartsWith("light.sides=two (the 'Lit sides' setting) shows "));
    // Its front, with the lamp behind it.
    const std::vector<VisibilityHint> front =
        hints_of(sheet(false), {"light.indirect=0", "light.position=0,0,3"});
    REQUIRE(front.size() == 1);
    CHECK(front[0].settings == std::vector<std::string>{"light.place=camera"});
    CHECK(hints_of(sheet(true), {"light.indirect=0", "light.power=0"}).empty());
    CHECK(hints_of(sheet(false), {"light.indirect=0"}).empty());
    CHECK(hints_of(sheet(true), {"light.indirect=0", "light.sides=two"}).empty());
    // An image can be the reason for black.
    const std::vector<VisibilityHint> image =
        hints_of(sheet_of("Kd 1 1 1\nmap_Kd black.png\n"), {});
    REQUIRE(image.size() == 1);
    CHECK(image[0].finding == "Everything you see is black");
    CHECK(image[0].settings == std::vector<std::string>{"texture=off"});
}

TEST_CASE("If all is transparent the hint names the settings that draw it opaque") {
    using namespace visibility_hints_of_models;
    const std::vector<std::string> no_blending{"blend=off"}, no_alpha{"texture_alpha=off"};
    for (const char* const d : {"d 0\n", "d 0.001\n", "Tr 0.9999\n"}) {
        INFO(d);
        const Scene scene = sheet_of(std::string("Kd 1 1 1\n") + d);
        const std::vector<VisibilityHint> hints = hints_of(scene, {});
        REQUIRE(hints.size() == 1);
        CHECK(hints[0].finding == "The model is transparent, so you cannot see it");
        CHECK(hints[0].settings == no_blending);
        CHECK(hints_of(scene, no_blending).empty());
        // Light would not show it either.
        CHECK(hints_of(scene, {"light.indirect=0", "light.position=0,0,3"}).empty());
    }
    const Scene cut_out = sheet_of("Kd 1 1 1\nmap_Kd clear.png\n");
    const std::vector<VisibilityHint> hints = hints_of(cut_out, {});
    REQUIRE(hints.size() == 1);
    CHECK(hints[0].settings == no_alpha);
    CHECK(hints_of(cut_out, no_alpha).empty());
    CHECK(hints_of(cut_out, {"texture_alpha=blend"}).empty()); // faint, but seen
    CHECK(hints_of(sheet_of("Kd 1 1 1\nd 0.5\n"), {}).empty());
    // The black part stays black.
    const std::vector<VisibilityHint> part =
        hints_of(two_sheets("Kd 0 0 0\n", "Kd 1 1 1\nd 0\n"), {"light.indirect=0.5"});
    REQUIRE(part.size() == 1);
    CHECK(part[0].finding == "Everything you see is black or transparent");
    CHECK(part[0].settings == no_blending);
    CHECK_THAT(part[0].help, StartsWith("blend=off (the 'Half-transparent' setting) shows "));
    const std::vector<VisibilityHint> both =
        hints_of(sheet_of("Kd 1 1 1\nd 0\nmap_Kd clear.png\n"), {});
    REQUIRE(both.size() == 1);
    CHECK(both[0].settings == std::vector<std::string>{"blend=off", "texture_alpha=off"});
    CHECK_THAT(both[0].help,
               ContainsSubstring("' setting) and texture_alpha=off (the 'Texture alpha' "
                                 "setting) show "));
}

TEST_CASE("Hints found in parts are the same, and too much work has none") {
    using namespace visibility_hints_of_models;
    const Scene scene = box(true);
    const Frame frame = prepare_frame(scene, settings_of(scene, {}));
    const Framebuffer picture = draw_frame(frame);
    VisibilityHintsWork work(frame, picture);
    int parts = 0;
    for (; !work.is_done(); ++parts)
        work.advance({2'000.0, 2'000.0});
    CHECK(parts > 20);
    CHECK(work.hints() == visibility_hints(frame, picture));
    VisibilityHintsWork stopped(frame, picture);
    while (!stopped.is_done())
        stopped.advance({2'000.0, 2'000.0, 1'000.0});
    CHECK(stopped.hints().empty());
}
