// Scenes and settings of no practical use: the fast engine finishes, stays within its memory, and
// draws black or something sensible.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "engines/fast/fast_engine.h"
#include "engines/fast/simd_level.h"
#include "scene/scene.h"
#include "settings/setting_table.h"
#include "settings/settings.h"
#include "support/choices.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/random.h"
#include "support/samples.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

/// What is wrong with a picture on its own, in words: every pixel is black and empty, or shows a
/// triangle of the scene at a depth in front of the camera.
std::string insane(const FastPicture& picture, const Scene& scene) {
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const std::size_t at = picture.at(column, row);
            const int owner = picture.owner[at];
            const float inv_z = picture.inv_z[at];
            const bool is_empty = owner == -1 && inv_z == 0.0f && picture.colour[at] == 0;
            const bool is_seen = owner >= 0 && owner < scene.triangle_count() && inv_z > 0.0f &&
                                 std::isfinite(inv_z) && picture.colour[at] <= 0xffffff;
            if (is_empty || is_seen) continue;
            return fmt::format("column {}, row {}: colour {:06x}, 1/z {}, owner {}", column, row,
                               picture.colour[at], inv_z, owner);
        }
    }
    return {};
}

bool sees_anything(const FastPicture& picture) {
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            if (picture.owner[picture.at(column, row)] >= 0) return true;
        }
    }
    return false;
}

/// Draws at all levels, with one thread and two.
/// @return whether anything is seen
bool check_sane(const Scene& scene, const Settings& settings) {
    bool is_seen = false;
    for (const SimdLevel level : simd_levels()) {
        for (const int threads : {1, 2}) {
            const FastPicture picture =
                fast_picture(scene, settings, {.level = level, .threads = threads});
            const std::string fault = insane(picture, scene);
            if (!fault.empty()) FAIL_CHECK(word_of(level) << ", " << threads << ": " << fault);
            is_seen |= sees_anything(picture);
        }
    }
    return is_seen;
}

Settings small_settings_of(const Scene& scene, const StripStep& step) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.viewport = {61, 47};
    settings.camera.focal_length = 50.0f;
    return settings;
}

constexpr StripStep all_steps[] = {StripStep::pixel_light, StripStep::vertex_light,
                                   StripStep{Stage::shade, Shading::unlit}};

/// The room with a texture on every third triangle, and surfaces that shine.
Scene hostile_room() {
    Scene scene = lab_room();
    scene.light.model = LightModel::blinn_phong;
    scene.textures.emplace_back(make_texture("one.png", many_colours(1, 1)));
    scene.parts.clear();
    Mesh mesh;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(scene, t);
        for (Vertex& corner : corners)
            corner.shine = {glm::vec3(0.5f), 20.0f};
        mesh.add_triangle_of(corners);
        scene.parts.push_back({"part", t, 1, {}, t % 3 == 0 ? 0 : -1});
    }
    scene.mesh = mesh;
    return scene;
}

/// The scene with every vertex changed.
Scene with_vertices(const Scene& scene, const std::function<void(Vertex&)>& change) {
    Scene changed = scene;
    Mesh mesh;
    for (Vertex vertex : scene.mesh.vertices()) {
        change(vertex);
        mesh.add_vertex(vertex);
    }
    for (const TriangleIndices& triangle : scene.mesh.triangles())
        mesh.add_triangle(triangle);
    changed.mesh = mesh;
    return changed;
}

float& any_number(Vertex& vertex, Random& random) {
    const int axis = random.integer(0, 2);
    switch (random.integer(0, 5)) {
    case 0:
        return vertex.position[axis];
    case 1:
        return vertex.normal[axis];
    case 2:
        return vertex.reflectance[axis];
    case 3:
        return vertex.texcoord[axis % 2];
    case 4:
        return vertex.shine.specular[axis];
    default:
        return vertex.shine.exponent;
    }
}

} // namespace

TEST_CASE("The fast engine draws scenes with NaN, infinity or the largest numbers") {
    const Scene room = hostile_room();
    constexpr float numbers[] = {nan_value, infinite, -infinite, 1e30f, -1e30f, 1e-30f,
                                 3.4e38f,   1e15f,    -1e10f,    1e7f,  -0.0f,  1e-40f};
    Random random(831);
    int seen = 0;
    const int scenes = rounds(3000, 150);
    for (int i = 0; i < scenes; ++i) {
        const float number = numbers[i % std::size(numbers)];
        const int one_of = random.integer(1, 40);
        const Scene scene = with_vertices(room, [&](Vertex& vertex) {
            if (random.integer(1, one_of) == 1) any_number(vertex, random) = number;
        });
        CAPTURE(i, number);
        seen += check_sane(scene, small_settings_of(scene, all_steps[i % 3])) ? 1 : 0;
    }
    CHECK(seen > scenes / 2);
}

TEST_CASE("The fast engine draws triangles of any shape that floats can have") {
    Random random(832);
    int seen = 0;
    const int scenes = rounds(3000, 150);
    for (int i = 0; i < scenes; ++i) {
        Scene scene = hostile_room();
        scene.parts.clear();
        scene.mesh = {};
        for (int t = 0; t < 12; ++t) {
            std::array<Vertex, triangle_corners> corners;
            const double size = std::pow(10.0, random.real(-6.0, 9.0));
            for (Vertex& corner : corners) {
                for (int axis = 0; axis < 3; ++axis)
                    corner.position[axis] = random.number(-size, size);
                corner.normal = {0.0f, 0.0f, -1.0f};
            }
            // Slivers, and no area at all.
            if (random.integer(0, 2) == 0)
                corners[2].position =
                    glm::mix(corners[0].position, corners[1].position, random.number(0.0, 1.0)) +
                    glm::vec3(0.0f, random.number(0.0, 1e-3), 0.0f);
            if (random.integer(0, 5) == 0) corners[1].position = corners[0].position;
            for (Vertex& corner : corners)
                corner.reflectance[random.integer(0, 2)] = random.number(0.0, 1.0);
            scene.parts.push_back({"part", t, 1, {}, t % 2 - 1});
            scene.mesh.add_triangle_of(corners);
        }
        CAPTURE(i);
        seen += check_sane(scene, small_settings_of(scene, all_steps[i % 3])) ? 1 : 0;
    }
    CHECK(seen > scenes / 2);
}

TEST_CASE("The fast engine shows no triangle nearer or farther than its corners") {
    Random random(833);
    int compared = 0;
    for (int i = 0; i < rounds(4000, 200); ++i) {
        Scene scene;
        scene.camera = {glm::vec3(0.0f), 0.0f, 0.0f, 60.0f};
        scene.light.position = {0.0f, -1.0f, 0.0f};
        std::array<Vertex, triangle_corners> corners;
        for (Vertex& corner : corners)
            corner.position = {random.number(-2, 2), random.number(-2, 2), random.number(0.5, 9)};
        // Seen from the side: a sliver that runs away from the camera.
        if (i % 2 == 0)
            corners[2].position = corners[0].position * random.number(1.5, 4.0) +
                                  glm::vec3(random.number(-0.01, 0.01), 0.0f, 0.0f);
        const glm::vec3 normal =
            face_normal(corners[0].position, corners[1].position, corners[2].position);
        float nearest = 0.0f, farthest = 1e9f;
        for (Vertex& corner : corners) {
            corner.normal = normal;
            nearest = std::max(nearest, 1.0f / corner.position.z);
            farthest = std::min(farthest, 1.0f / corner.position.z);
        }
        scene.mesh.add_triangle_of(corners);
        Settings settings = default_settings(scene);
        set_step(settings, all_steps[i % 3]);
        settings.viewport = {90, 70};
        CAPTURE(i);
        for (const SimdLevel level : simd_levels()) {
            const FastPicture picture = fast_picture(scene, settings, {.level = level});
            for (int row = 0; row < picture.size.height; ++row) {
                for (int column = 0; column < picture.size.width; ++column) {
                    const float inv_z = picture.inv_z[picture.at(column, row)];
                    if (picture.owner[picture.at(column, row)] < 0) continue;
                    ++compared;
                    if (inv_z < farthest * 0.999f || inv_z > nearest * 1.001f)
                        FAIL(word_of(level) << ": column " << column << ", row " << row << ": "
                                            << inv_z << ", not " << farthest << " to " << nearest);
                }
            }
        }
    }
    CHECK(compared > 10000);
}

TEST_CASE("The fast engine draws with any camera, lamp and exponent") {
    const Scene room = hostile_room();
    Random random(834);
    constexpr float focal_lengths[] = {1.0f, 0.5f, 1000.0f, 100000.0f};
    constexpr float exponents[] = {0.0f, 1.0f, 10000.0f, 1e6f, 1e15f};
    int seen = 0;
    const int views = rounds(1000, 80);
    for (int i = 0; i < views; ++i) {
        const float exponent = exponents[i % std::size(exponents)];
        const Scene scene =
            with_vertices(room, [&](Vertex& vertex) { vertex.shine.exponent = exponent; });
        Settings settings = small_settings_of(scene, all_steps[i % 3]);
        settings.camera.focal_length = focal_lengths[i % std::size(focal_lengths)];
        settings.near = i % 5 == 0 ? 1e-6f : 0.1f;
        const Vertex& vertex = scene.corner(random.integer(0, 29), random.integer(0, 2));
        switch (i % 6) {
        case 0: // in a corner of a surface
            settings.camera.position = vertex.position;
            break;
        case 1: // in the plane of a wall
            settings.camera.position = {1.0f, 0.0f, -2.0f};
            break;
        case 2: // at the lamp, which is in a surface
            settings.camera.position = settings.light.position = vertex.position;
            break;
        case 3: // all of it is behind
            settings.camera.position.z = 50.0f;
            break;
        case 4:
            settings.light.place = LampPlace::camera;
            settings.light.power = glm::vec3(largest_power);
            break;
        default:
            settings.light.power = settings.light.indirect = glm::vec3(0.0f);
            settings.camera.yaw = largest_yaw;
            settings.camera.pitch = largest_pitch;
            break;
        }
        CAPTURE(i, exponent);
        seen += check_sane(scene, settings) ? 1 : 0;
    }
    CHECK(seen > views / 3);
}

TEST_CASE("The fast engine draws empty scenes") {
    Scene empty;
    empty.viewport = {20, 10};
    CHECK_FALSE(check_sane(empty, default_settings(empty)));
    // Vertices without triangles, triangles without parts, and all of them behind the camera.
    empty.mesh.add_vertex({});
    CHECK_FALSE(check_sane(empty, default_settings(empty)));
    Scene room = lab_room();
    room.parts.clear();
    Settings settings = small_settings_of(room, StripStep::pixel_light);
    CHECK(check_sane(room, settings));
    settings.camera.position.z = 100.0f;
    CHECK_FALSE(check_sane(room, settings));
}

TEST_CASE("The fast engine draws textures of one texel and of odd sizes, at any coordinates") {
    Random random(835);
    constexpr std::array<int, 2> sizes[] = {{1, 1}, {1, 9}, {7, 1}, {5, 3}};
    for (const auto& [width, height] : sizes) {
        for (const char* wrap : {"repeat", "clamp", "mirror"}) {
            for (const char* filter : {"nearest", "bilinear"}) {
                for (const float most : {2.0f, 1000.0f, 1e14f}) {
                    Scene scene = with_vertices(hostile_room(), [&](Vertex& vertex) {
                        vertex.texcoord = {random.number(-most, most), random.number(-most, most)};
                    });
                    scene.textures.clear();
                    scene.textures.emplace_back(
                        make_texture("odd.png", many_colours(width, height)));
                    Settings settings = small_settings_of(scene, StripStep::pixel_light);
                    set_from_text(settings, std::string("texture_wrap=") + wrap);
                    set_from_text(settings, std::string("texture_filter=") + filter);
                    CAPTURE(width, height, wrap, filter, most);
                    CHECK(check_sane(scene, settings));
                }
            }
        }
    }
}

TEST_CASE("The fast engine draws the largest picture") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_step(settings, StripStep::pixel_light);
    settings.viewport = {largest_viewport, largest_viewport};
    settings.camera.focal_length = static_cast<float>(largest_viewport);
    FastEngine engine(room, {.threads = 2});
    FastPicture picture;
    engine.draw(settings, picture);
    CHECK(insane(picture, room) == "");
    CHECK(picture.owner[picture.at(largest_viewport / 2, largest_viewport / 2)] >= 0);
    CHECK(picture.owner[picture.at(largest_viewport - 2, largest_viewport - 2)] >= 0);
}

TEST_CASE("A level that the machine does not have is refused by name") {
    const std::vector<SimdLevel> levels = simd_levels();
    CHECK(best_simd_level() == levels.back());
    CHECK(std::is_sorted(levels.begin(), levels.end()));
    for (const SimdLevel level : {SimdLevel::scalar, SimdLevel::sse2, SimdLevel::clones,
                                  SimdLevel::avx2, SimdLevel::avx512}) {
        if (std::find(levels.begin(), levels.end(), level) != levels.end()) continue;
        CHECK_THROWS_AS(FastEngine(lab_room(), {.level = level}), UsageError);
    }
}
