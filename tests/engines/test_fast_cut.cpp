// Triangles that the near plane and the guard band cut: what is left of them covers each pixel
// once, and shows what a ray meets.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "engines/fast/fast_data.h"
#include "engines/fast/fast_engine.h"
#include "engines/fast/simd_level.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "stages/vertex_shader.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/random.h"
#include "support/ray_picture.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A floor of triangles that share their corners, some of them behind the camera or far to its
/// side.
struct Floor {
    Scene scene;
    std::vector<TriangleIndices> triangles;
};

Vertex floor_vertex(const glm::vec3& position) {
    Vertex vertex;
    vertex.position = position;
    vertex.normal = {0.0f, -1.0f, 0.0f};
    return vertex;
}

Scene scene_seen_from(const Camera& camera, Viewport size) {
    Scene scene;
    scene.camera = camera;
    scene.viewport = size;
    scene.light = {{0.0f, -1.0f, 0.0f}, glm::vec3(20.0f), glm::vec3(0.5f)};
    return scene;
}

/// A fan about a place in front of the camera: its rim lies all round, beyond the near plane or the
/// guard band, so that it fills the picture.
Floor fan_around(Viewport size, Random& random) {
    Floor floor;
    const float focal_length = random.number(20, 400);
    floor.scene = scene_seen_from({glm::vec3(0.0f), 0.0f, 0.0f, focal_length}, size);
    const float z = random.number(1, 4), across = z * static_cast<float>(size.width) / focal_length;
    floor.scene.mesh.add_vertex(
        floor_vertex({random.number(-0.4, 0.4) * across, random.number(-0.3, 0.3) * across, z}));
    const int rim = random.integer(7, 16);
    // Far enough out that its chords run past the picture; some of it behind the camera.
    const double tilt = random.real(-0.05, 0.05),
                 radius = z * random.real(9000, 40000) / focal_length;
    for (int i = 0; i < rim; ++i) {
        const double angle = 2.0 * 3.14159265358979 * (i + random.real(0.0, 0.3)) / rim;
        const double far = radius * random.real(1.0, 3.0);
        const double x = far * std::cos(angle), y = far * std::sin(angle);
        floor.scene.mesh.add_vertex(floor_vertex(
            {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z + tilt * x)}));
    }
    for (int i = 0; i < rim; ++i) {
        TriangleIndices triangle{0, 1 + i, 1 + (i + 1) % rim};
        if (random.integer(0, 1) == 0) std::swap(triangle[1], triangle[2]);
        floor.triangles.push_back(triangle);
        floor.scene.mesh.add_triangle(triangle);
    }
    return floor;
}

/// Bumpy ground that begins behind the camera, below it, and is wider than the guard band; and a
/// ceiling, so that the background shows only between the two.
Floor ground(Viewport size, Random& random) {
    Floor floor;
    Camera camera{glm::vec3(0.0f), random.number(-3, 3), random.number(-0.2, 0.2),
                  random.number(20, 200)};
    floor.scene = scene_seen_from(camera, size);
    const int cells = random.integer(2, 7);
    const double reach = random.real(2.0, 3000.0);
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const auto place = [&](int k) {
                return static_cast<float>(reach *
                                          ((2.0 * k + random.real(-0.4, 0.4)) / cells - 1.0));
            };
            floor.scene.mesh.add_vertex(floor_vertex({place(i), 1.0f, place(j)}));
        }
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = j * (cells + 1) + i, c = a + cells + 1;
            for (const TriangleIndices& triangle :
                 {TriangleIndices{a, a + 1, c}, TriangleIndices{a + 1, c + 1, c}}) {
                floor.triangles.push_back(triangle);
                floor.scene.mesh.add_triangle(triangle);
            }
        }
    }
    return floor;
}

Settings settings_of(const Scene& scene, Random& random) {
    Settings settings = default_settings(scene);
    set_step(settings, random.integer(0, 1) == 0 ? StripStep::pixel_light
                                                 : StripStep{Stage::shade, Shading::unlit});
    settings.near = random.integer(0, 1) == 0 ? 0.1f : 0.01f;
    return settings;
}

/// How many triangles cover each pixel, found by drawing each alone; row by row.
std::vector<int> covered_times(const Floor& floor, const Settings& settings, SimdLevel level) {
    std::vector<int> times(static_cast<std::size_t>(settings.viewport.width) *
                           static_cast<std::size_t>(settings.viewport.height));
    for (const TriangleIndices& triangle : floor.triangles) {
        Scene alone = floor.scene;
        alone.mesh = {};
        for (const Vertex& vertex : floor.scene.mesh.vertices())
            alone.mesh.add_vertex(vertex);
        alone.mesh.add_triangle(triangle);
        const FastPicture picture = fast_picture(alone, settings, {.level = level});
        for (int row = 0; row < picture.size.height; ++row) {
            for (int column = 0; column < picture.size.width; ++column)
                times[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.size.width) +
                      static_cast<std::size_t>(column)] +=
                    picture.owner[picture.at(column, row)] >= 0 ? 1 : 0;
        }
    }
    return times;
}

/// Where a whole picture is covered differently from its triangles one by one, or more than once.
/// @param is_full no pixel may show the background
std::string cut_fault(const Floor& floor, const Settings& settings, SimdLevel level, bool is_full) {
    const std::vector<int> times = covered_times(floor, settings, level);
    const FastPicture picture = fast_picture(floor.scene, settings, {.level = level});
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const int count =
                times[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.size.width) +
                      static_cast<std::size_t>(column)];
            const bool is_owned = picture.owner[picture.at(column, row)] >= 0;
            if (count <= 1 && is_owned == (count == 1) && (is_owned || !is_full)) continue;
            return fmt::format("{}: column {}, row {} is covered {} times", word_of(level), column,
                               row, count);
        }
    }
    return {};
}

/// The pixels away from the outlines that show a different triangle from the one the ray meets.
std::string ray_fault(const Floor& floor, const Settings& settings, SimdLevel level) {
    constexpr double margin = 1.0 / 16.0, all_depths = 1e7;
    const std::vector<int> met = cast_rays(floor.scene, settings.camera, settings.viewport,
                                           {settings.near, all_depths}, margin);
    const FastPicture picture = fast_picture(floor.scene, settings, {.level = level});
    std::size_t at = 0;
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column, ++at) {
            const int owner = picture.owner[picture.at(column, row)];
            if (met[at] == ray_near_outline || met[at] == owner) continue;
            return fmt::format("{}: column {}, row {}: owner {}, ray {}", word_of(level), column,
                               row, owner, met[at]);
        }
    }
    return {};
}

/// Is a triangle cut, that is, does it have a corner behind the near plane or beyond the guard
/// band?
int count_cut(const Floor& floor, const Settings& settings) {
    const glm::mat3 axes = camera_rotation(settings.camera);
    const auto is_out = [&](int vertex) {
        const glm::vec3 place =
            (floor.scene.mesh.vertices()[static_cast<std::size_t>(vertex)].position -
             settings.camera.position) *
            axes;
        const float scale = settings.camera.focal_length / place.z;
        return place.z < settings.near || std::abs(place.x * scale) > fast::guard_band ||
               std::abs(place.y * scale) > fast::guard_band;
    };
    return static_cast<int>(std::count_if(
        floor.triangles.begin(), floor.triangles.end(), [&](const TriangleIndices& triangle) {
            return std::any_of(triangle.begin(), triangle.end(), is_out);
        }));
}

constexpr Viewport cut_picture{90, 70};

} // namespace

TEST_CASE("Triangles cut at the near plane and the guard band leave no holes and do not overlap") {
    Random random(811);
    int cut = 0;
    const int floors = rounds(400, 20);
    for (int i = 0; i < floors; ++i) {
        const Floor floor =
            i % 2 == 0 ? fan_around(cut_picture, random) : ground(cut_picture, random);
        const Settings settings = settings_of(floor.scene, random);
        CAPTURE(i);
        for (const SimdLevel level : simd_levels()) {
            const std::string fault = cut_fault(floor, settings, level, i % 2 == 0);
            if (!fault.empty()) FAIL_CHECK(fault);
        }
        cut += count_cut(floor, settings);
    }
    CHECK(cut > 4 * floors);
}

TEST_CASE("What is left of cut triangles is what rays meet") {
    Random random(812);
    const int floors = rounds(2000, 100);
    int cut = 0;
    for (int i = 0; i < floors; ++i) {
        const Floor floor =
            i % 2 == 0 ? fan_around(cut_picture, random) : ground(cut_picture, random);
        const Settings settings = settings_of(floor.scene, random);
        CAPTURE(i);
        for (const SimdLevel level : simd_levels()) {
            const std::string fault = ray_fault(floor, settings, level);
            if (!fault.empty()) FAIL_CHECK(fault);
        }
        cut += count_cut(floor, settings);
    }
    CHECK(cut > 4 * floors);
}

TEST_CASE("A corner just within the guard band stays in place for its cut neighbour too") {
    // Its far corner is cut off; the edge that it shares with a whole triangle must not move.
    Random random(813);
    for (int i = 0; i < rounds(400, 60); ++i) {
        const Viewport size{300, 40};
        Floor floor;
        floor.scene = scene_seen_from({glm::vec3(0.0f), 0.0f, 0.0f, 256.0f}, size);
        // Pixels from the middle, at depth 1.
        const auto place = [](double x, double y) {
            return floor_vertex(
                {static_cast<float>(x / 256.0), static_cast<float>(y / 256.0), 1.0f});
        };
        const double edge_of_band = fast::guard_band - size.width / 2;
        floor.scene.mesh.add_vertex(place(-200.0, random.real(-15, 15)));
        floor.scene.mesh.add_vertex(
            place(edge_of_band - random.real(0.0, 1.0), random.real(-900, 900)));
        floor.scene.mesh.add_vertex(place(random.real(-100, 100), -3000.0));
        floor.scene.mesh.add_vertex(place(edge_of_band + 3000.0, 5000.0));
        for (const TriangleIndices& triangle :
             {TriangleIndices{0, 1, 2}, TriangleIndices{0, 1, 3}}) {
            floor.triangles.push_back(triangle);
            floor.scene.mesh.add_triangle(triangle);
        }
        Settings settings = default_settings(floor.scene);
        CAPTURE(i);
        for (const SimdLevel level : simd_levels()) {
            const std::string fault = cut_fault(floor, settings, level, false);
            if (!fault.empty()) FAIL_CHECK(fault);
        }
    }
}
