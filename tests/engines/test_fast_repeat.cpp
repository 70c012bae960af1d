// Neither the number of threads nor what the engine has drawn before may change a bit of the fast
// engine's picture. Whether depth and owner are kept may only change rounding.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "engines/fast/fast_engine.h"
#include "engines/fast/simd_level.h"
#include "scene/scene.h"
#include "settings/setting_table.h"
#include "settings/settings.h"
#include "support/choices.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/made_scene.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A scene and the settings of a picture of it.
struct FastShot {
    std::string name;
    Settings settings;
};

Settings settings_at(const Scene& scene, const char* shading, Viewport size) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    settings.normal_map = NormalMapUse::off;
    settings.parallax = Parallax::off;
    set_from_text(settings, shading);
    settings.camera.focal_length *=
        static_cast<float>(size.width) / static_cast<float>(settings.viewport.width);
    settings.viewport = size;
    return settings;
}

/// Pictures that have little in common: different sizes, cut triangles, different light.
std::vector<FastShot> shots_of(const Scene& scene) {
    std::vector<FastShot> shots{
        {"own", settings_at(scene, "shading=phong", {203, 151})},
        {"gouraud", settings_at(scene, "shading=gouraud", {90, 240})},
        {"inside", settings_at(scene, "shading=phong", {160, 120})},
        {"inside, gouraud", settings_at(scene, "shading=gouraud", {97, 61})},
        {"tiny", settings_at(scene, "shading=unlit", {5, 2})},
        {"lamp at the camera", settings_at(scene, "shading=phong", {64, 64})},
        {"nothing", settings_at(scene, "shading=phong", {33, 33})}};
    shots[2].settings.camera.position += glm::vec3(0.1f, 0.2f, 2.4f);
    shots[2].settings.camera.yaw += 0.6f;
    shots[3].settings.camera.position += glm::vec3(-0.2f, 0.1f, 3.0f);
    shots[3].settings.camera.focal_length *= 0.3f;
    shots[5].settings.light.place = LampPlace::camera;
    // Everything is behind the camera.
    shots[6].settings.camera.position.z += 1000.0f;
    return shots;
}

/// Pairs of triangles with an edge in common, each pair in a plane that faces the camera: some form
/// a convex quadrilateral, some are bent inward there, some lie on each other.
Scene pairs_of_triangles() {
    Scene scene = lesson_scene("lab-room");
    scene.mesh = Mesh();
    scene.textures.clear();
    scene.parts.clear();
    Random random(4471);
    const auto within = [&] { return static_cast<float>(random.real(-1.0, 1.0)); };
    for (int pair = 0; pair < 40; ++pair) {
        Vertex vertex;
        vertex.normal = {0.0f, 0.0f, -1.0f};
        vertex.reflectance = {0.1f + 0.02f * static_cast<float>(pair), 0.9f, 0.5f};
        std::array<int, 4> corners{};
        for (int& corner : corners) {
            vertex.position = {within(), within(), 1.0f - 0.04f * static_cast<float>(pair)};
            corner = scene.mesh.add_vertex(vertex);
        }
        scene.mesh.add_triangle({corners[0], corners[1], corners[2]});
        scene.mesh.add_triangle({corners[2], corners[1], corners[3]});
        // In the other orientation.
        if (pair % 3 == 0) scene.mesh.add_triangle({corners[1], corners[2], corners[3]});
    }
    scene.parts.push_back({"pairs", 0, scene.mesh.triangle_count()});
    return scene;
}

std::vector<Scene> scenes_to_repeat() {
    return {lesson_scene("lab-room"), lesson_scene("checkered-room"),
            lesson_scene("corridor"), lesson_scene("cylinder"),
            made_scene(3000),         pairs_of_triangles()};
}

/// The colours of a picture alone, row by row.
std::vector<std::uint32_t> colours_of(const FastPicture& picture) {
    std::vector<std::uint32_t> colours;
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column)
            colours.push_back(picture.colour[picture.at(column, row)]);
    }
    return colours;
}

} // namespace

TEST_CASE("The fast engine's picture is the same bits with one thread, two and three") {
    int painted = 0;
    for (const Scene& scene : scenes_to_repeat()) {
        for (const SimdLevel level : simd_levels()) {
            FastEngine two(scene, {.level = level, .threads = 2});
            FastEngine three(scene, {.level = level, .threads = 3});
            // For all but the first picture, the previous picture decides how tall the bands are.
            for (int round = 0; round < rounds(5, 2); ++round) {
                for (const FastShot& shot : shots_of(scene)) {
                    CAPTURE(scene.name, word_of(level), shot.name, round);
                    const FastPicture one = fast_picture(scene, shot.settings, {.level = level});
                    FastPicture picture;
                    two.draw(shot.settings, picture);
                    CHECK(first_other_bits(one, picture) == "");
                    three.draw(shot.settings, picture);
                    CHECK(first_other_bits(one, picture) == "");
                    const std::vector<std::uint32_t> colours = colours_of(one);
                    painted += std::any_of(colours.begin(), colours.end(),
                                           [](std::uint32_t colour) { return colour != 0; });
                }
            }
        }
    }
    CHECK(painted > 20);
}

/// The largest difference of a channel.
int largest_difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (const int shift : {0, 8, 16}) {
            const int of_a = static_cast<int>(a[i] >> shift & 255),
                      of_b = static_cast<int>(b[i] >> shift & 255);
            largest = std::max(largest, std::abs(of_a - of_b));
        }
    }
    return largest;
}

TEST_CASE("Keeping depth and owner changes no colour by more than rounding") {
    for (const Scene& scene : scenes_to_repeat()) {
        for (const SimdLevel level : simd_levels()) {
            FastEngine one(scene, {.level = level, .keeps_planes = false});
            FastEngine two(scene, {.level = level, .threads = 2, .keeps_planes = false});
            FastPicture of_one, of_two;
            for (const FastShot& shot : shots_of(scene)) {
                CAPTURE(scene.name, word_of(level), shot.name);
                one.draw(shot.settings, of_one);
                two.draw(shot.settings, of_two);
                CHECK((colours_of(of_one) == colours_of(of_two)));
                const FastPicture kept = fast_picture(scene, shot.settings, {.level = level});
                REQUIRE(kept.size == of_one.size);
                // Without owners two triangles in one plane are drawn as one, with the numbers of
                // the first.
                CHECK(largest_difference(colours_of(of_one), colours_of(kept)) <= 1);
                CHECK(of_one.owner.empty());
                CHECK(of_one.inv_z.empty());
            }
        }
    }
}

TEST_CASE("Nothing drawn before is left in the fast engine's next picture") {
    Random random(821);
    for (const Scene& scene : scenes_to_repeat()) {
        for (const SimdLevel level : simd_levels()) {
            for (const int threads : {1, 3}) {
                FastEngine engine(scene, {.level = level, .threads = threads});
                FastPicture picture;
                const std::vector<FastShot> shots = shots_of(scene);
                std::string before = "nothing yet";
                for (int i = 0; i < rounds(60, 12); ++i) {
                    const FastShot& shot = shots[static_cast<std::size_t>(
                        random.integer(0, static_cast<int>(shots.size()) - 1))];
                    CAPTURE(scene.name, word_of(level), threads, before, shot.name);
                    engine.draw(shot.settings, picture);
                    const FastPicture fresh = fast_picture(scene, shot.settings, {.level = level});
                    CHECK(first_other_bits(fresh, picture) == "");
                    before = shot.name;
                }
            }
        }
    }
}

TEST_CASE("A picture with depth and owner drops them when an engine does not keep them") {
    const Scene room = lesson_scene("lab-room");
    const Settings large = settings_at(room, "shading=phong", {80, 60});
    FastPicture picture = fast_picture(room, large, {});
    CHECK_FALSE(picture.owner.empty());
    FastEngine(room, {.keeps_planes = false})
        .draw(settings_at(room, "shading=phong", {200, 100}), picture);
    CHECK(picture.owner.empty());
    CHECK(picture.inv_z.empty());
}
