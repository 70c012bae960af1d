// What the ladder refuses, and scenes of no practical use: each is refused or drawn, in time.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "base/error.h"
#include "engines/ladder/ladder.h"
#include "engines/ladder/race.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

Settings settings_to_refuse(const Scene& scene) {
    Settings settings = default_settings(scene);
    set_step(settings, StripStep::pixel_light);
    settings.viewport = {60, 40};
    settings.camera.focal_length = 40.0f;
    return settings;
}

/// With one corner of the room's first triangle at this place.
std::string refused_corner(const glm::vec3& at) {
    Scene room = lab_room();
    room.mesh.place_corner(0, 0, at);
    return ladder_refuses(room, settings_to_refuse(room));
}

} // namespace

TEST_CASE("The ladder says what it does not draw") {
    const Scene room = lab_room();
    REQUIRE(ladder_refuses(room, settings_to_refuse(room)) == "");
    const auto refused = [&](const std::string& assignment) {
        Settings settings = settings_to_refuse(room);
        set_from_text(settings, assignment);
        return ladder_refuses(room, settings);
    };
    CHECK_THAT(refused("stage=depth"), ContainsSubstring("light"));
    CHECK_THAT(refused("camera.yaw=0.1"), ContainsSubstring("turned"));
    CHECK_THAT(refused("cull=screen_area"), ContainsSubstring("culling"));
    CHECK_THAT(refused("light.place=camera"), ContainsSubstring("lamp"));
    CHECK_THAT(refused("shadows=map"), ContainsSubstring("shadows"));
    CHECK_THAT(refused("tessellation=2"), ContainsSubstring("tessellation"));
    CHECK_THAT(refused("shading=flat"), ContainsSubstring("flat"));
    CHECK_THAT(refused("interpolation=affine"), ContainsSubstring("interpolation"));
    const Scene floor = read_scene(lessons_folder() + "/scenes/checkered-floor.toml");
    CHECK_THAT(ladder_refuses(floor, settings_to_refuse(floor)), ContainsSubstring("textures"));
    Scene colours = room;
    colours.mesh = {};
    std::array<Vertex, triangle_corners> corners = corners_of(room, 0);
    corners[1].reflectance = glm::vec3(0.0f);
    colours.mesh.add_triangle_of(corners);
    CHECK_THAT(ladder_refuses(colours, settings_to_refuse(colours)), ContainsSubstring("colour"));
}

TEST_CASE("The ladder refuses corners that no row table could hold") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    CHECK(refused_corner({0.0f, 0.0f, 0.5f}) == "");
    CHECK_THAT(refused_corner({nan, 0.0f, 0.0f}), ContainsSubstring("not finite"));
    CHECK_THAT(refused_corner({0.0f, 0.0f, infinite}), ContainsSubstring("not finite"));
    CHECK_THAT(refused_corner({0.0f, 0.0f, -3.5f}), ContainsSubstring("near plane"));
    CHECK_THAT(refused_corner({0.0f, 0.0f, -3.0f}), ContainsSubstring("near plane"));
    CHECK_THAT(refused_corner({1e6f, 0.0f, 0.0f}), ContainsSubstring("pixels from"));
    CHECK_THAT(refused_corner({0.0f, -1e6f, 0.0f}), ContainsSubstring("pixels from"));
    Scene many = lab_room();
    const std::array<Vertex, triangle_corners> wall = corners_of(many, 0);
    Settings settings = settings_to_refuse(many);
    settings.viewport = {2000, 2000};
    settings.camera.focal_length = 2000.0f;
    CHECK(ladder_refuses(many, settings) == "");
    for (int i = 0; i < 100; ++i)
        many.mesh.add_triangle_of(wall);
    CHECK_THAT(ladder_refuses(many, settings), ContainsSubstring("too long"));
    LadderWork work;
    CHECK_THROWS_AS(work.begin(std::make_shared<Scene>(many), settings, 1), UsageError);
}

TEST_CASE("The ladder refuses pictures whose copies would fill the memory") {
    const Scene room = lab_room();
    Settings settings = settings_to_refuse(room);
    settings.viewport = {4096, 4096};
    CHECK_THAT(ladder_refuses(room, settings), ContainsSubstring("more than 4 million pixels"));
    settings.viewport = {4000, 1000};
    CHECK(ladder_refuses(room, settings) == "");
    settings.viewport = {4000, 1001};
    CHECK_THAT(ladder_refuses(room, settings), ContainsSubstring("too much memory"));
}

TEST_CASE("Whatever the ladder does not refuse it draws") {
    constexpr float numbers[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(),
                                 1e30f,
                                 -1e30f,
                                 1e-30f,
                                 1e4f,
                                 -200.0f,
                                 -0.0f,
                                 3.0f};
    Random random(912);
    int drawn = 0, refused = 0;
    for (int i = 0; i < rounds(2000, 120); ++i) {
        const Scene room = lab_room();
        Scene scene = room;
        scene.mesh = {};
        for (int t = 0; t < room.triangle_count(); ++t) {
            std::array<Vertex, triangle_corners> corners = corners_of(room, t);
            if (random.integer(0, 20) == 0) {
                Vertex& corner = corners[static_cast<std::size_t>(random.integer(0, 2))];
                const float number = numbers[static_cast<std::size_t>(random.integer(0, 8))];
                (random.integer(0, 2) == 0 ? corner.normal
                                           : corner.position)[random.integer(0, 2)] = number;
            }
            if (random.integer(0, 10) == 0) corners[1] = corners[0];
            scene.mesh.add_triangle_of(corners);
        }
        Settings settings = settings_to_refuse(scene);
        if (i % 2 == 0) settings.shading = Shading::gouraud;
        if (i % 5 == 0) settings.light.position = scene.corner(random.integer(0, 29), 0).position;
        if (!ladder_refuses(scene, settings).empty()) {
            ++refused;
            continue;
        }
        ++drawn;
        for (std::size_t place = 0; place < rung_count(); ++place)
            CHECK(rung_at(place).make(scene, settings)->picture(0).colour.size() == 60 * 40);
    }
    CHECK(drawn > 20);
    CHECK(refused > 20);
    Scene empty;
    const Settings settings = settings_to_refuse(empty);
    REQUIRE(ladder_refuses(empty, settings) == "");
    for (const Rung& rung : ladder()) {
        for (const std::uint32_t colour : rung.make(empty, settings)->picture(0).colour)
            REQUIRE(colour == 0);
    }
}
