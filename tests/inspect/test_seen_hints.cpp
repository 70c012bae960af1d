// What is counted on the picture of a model, against rays in double, and which settings are named.

#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "inspect/seen_hints.h"
#include "pipeline/draw.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "settings/setting_table.h"
#include "support/choices.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::StartsWith;

namespace {
namespace seen_hints_of_models {

/// A box without a side toward the camera's right; its fronts point inward or outward.
Scene box(bool is_inward) {
    const std::string corners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                                "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    const std::string inward = "f 5 6 2 1\nf 4 3 7 8\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 1 2 3 4\n";
    const std::string outward =
        "f 1 2 6 5\nf 8 7 3 4\nf 7 8 5 6\nf 8 4 1 5\nf 3 7 6 2\nf 4 3 2 1\n";
    const test::TemporaryFolder folder;
    return scene_of_model(
        read_obj(folder.write("box.obj", corners + (is_inward ? inward : outward))));
}

/// One triangle that shows its back or its front.
Scene sheet(bool shows_back) {
    const test::TemporaryFolder folder;
    return scene_of_model(
        read_obj(folder.write("sheet.obj", std::string("v -1 -1 0\nv 1 -1 0\nv 0 1 0\n") +
                                               (shows_back ? "f 3 2 1\n" : "f 1 2 3\n"))));
}

Settings settings_of(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

std::vector<std::string> hints_of(const Scene& scene, const std::vector<std::string>& assignments) {
    const Frame frame = prepare_frame(scene, settings_of(scene, assignments));
    return seen_hints(frame, draw_frame(frame));
}

/// The same counts from the corners of the scene in double, and from the planes.
SeenPixels counted_otherwise(const Scene& scene, const Settings& settings) {
    const Framebuffer picture = draw_frame(prepare_frame(scene, settings));
    SeenPixels seen;
    for (std::size_t i = 0; i < picture.owner.size(); ++i) {
        const int t = picture.owner[i];
        if (t < 0) continue;
        const auto place = [&](int c) { return glm::dvec3(scene.corner(t, c).position); };
        // Corners of a front go round clockwise, y down: their cross product points to the eye.
        const glm::dvec3 across = glm::cross(place(2) - place(0), place(1) - place(0));
        ++seen.surface;
        seen.backs += glm::dot(across, place(0) - glm::dvec3(settings.camera.position)) > 0.0;
        seen.lit += picture.colour[i] != glm::vec3(0.0f);
    }
    return seen;
}

} // namespace seen_hints_of_models
} // namespace

TEST_CASE("Backs and black pixels are counted over the picture") {
    using namespace seen_hints_of_models;
    for (const Scene& scene : {box(true), box(false), sheet(true), sheet(false)}) {
        for (const char* light : {"light.indirect=0", "light.indirect=0.2"}) {
            const Settings settings = settings_of(scene, {light});
            const Frame frame = prepare_frame(scene, settings);
            const SeenPixels seen = count_seen(frame, draw_frame(frame));
            CHECK(seen == counted_otherwise(scene, settings));
            CHECK(seen.surface > 1000);
        }
    }
}

TEST_CASE("A box whose fronts point inward is told to be seen from behind, and no other") {
    using namespace seen_hints_of_models;
    const std::vector<std::string> hints = hints_of(box(true), {});
    REQUIRE(hints.size() == 1);
    CHECK_THAT(hints[0], StartsWith("Most of what you see are backs, "));
    CHECK(hints_of(box(true), {"cull=face_normal"}).empty());
    CHECK(hints_of(box(true), {"stage=rows"}).empty());
    CHECK(hints_of(box(false), {}).empty());
    // Nothing stands behind a sheet.
    CHECK(hints_of(sheet(true), {}).empty());
    // What the lab shows is meant.
    CHECK(hints_of(test::lesson_scene("lab-room"), {"light.indirect=0", "light.power=0"}).empty());
}

TEST_CASE("What is black all over is told the setting that lights most of it, or none") {
    using namespace seen_hints_of_models;
    const std::vector<std::string> back = hints_of(sheet(true), {"light.indirect=0"});
    REQUIRE(back.size() == 1);
    CHECK_THAT(back[0], StartsWith("All that you see is black: light.sides=two, "));
    // Its front, with the lamp behind it.
    const std::vector<std::string> front =
        hints_of(sheet(false), {"light.indirect=0", "light.position=0,0,3"});
    REQUIRE(front.size() == 1);
    CHECK_THAT(front[0], StartsWith("All that you see is black: light.place=camera, "));
    CHECK(hints_of(sheet(true), {"light.indirect=0", "light.power=0"}).empty());
    CHECK(hints_of(sheet(false), {"light.indirect=0"}).empty());
    CHECK(hints_of(sheet(true), {}).empty());
}
