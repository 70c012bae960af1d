// The figure of the chain of matrices, compared with sums in long double that use no matrix.

#include "explain/space_chain.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace space_chain_test {

using Real = long double;

struct Point {
    Real x, y, z, w;
};

/// The first triangle of the part "turned and scaled" of the scene with three blocks.
constexpr int block_triangle = 14;

/// Its corners E, B and A in the file.
constexpr Point block[] = {
    {-0.5L, -0.5L, -0.5L, 1}, {0.5L, 0.5L, -0.5L, 1}, {-0.5L, 0.5L, -0.5L, 1}};

/// Scaled by (1, 1.5, 0.6), turned about y by 0.7, moved by (0, 0.05, 0.4).
Point in_world(const Point& p) {
    const Real c = std::cos(0.7L), s = std::sin(0.7L);
    const Real x = p.x, y = 1.5L * p.y, z = 0.6L * p.z;
    return {c * x + s * z, y + 0.05L, c * z - s * x + 0.4L, 1};
}

/// A camera at (0, -0.6, -4) that is turned by yaw 0.25 and pitch -0.1.
Point in_camera(const Point& p) {
    const Real x = p.x, y = p.y + 0.6L, z = p.z + 4.0L;
    const Real cy = std::cos(0.25L), sy = std::sin(0.25L);
    const Real cp = std::cos(-0.1L), sp = std::sin(-0.1L);
    const Real ahead = sy * x + cy * z;
    return {cy * x - sy * z, sp * ahead + cp * y, cp * ahead - sp * y, 1};
}

/// f = 220 in a picture of 240 by 180, near = 0.1, far = 100.
Point in_clip(const Point& p) {
    constexpr Real n = 0.1L, f = 100.0L;
    return {220.0L / 120.0L * p.x, 220.0L / 90.0L * p.y, f / (f - n) * (p.z - n), p.z};
}

Point in_ndc(const Point& p) {
    return {p.x / p.w, p.y / p.w, p.z / p.w, 1};
}

Point in_window(const Point& p) {
    return {120.0L * (p.x + 1), 90.0L * (p.y + 1), p.z, 1};
}

Settings matrix_settings(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.camera.yaw = 0.25f;
    set_from_text(settings, "transform=matrices");
    return settings;
}

Scene three_blocks() {
    return read_scene(lessons_folder() + "/scenes/turned-block.toml");
}

void check_place(const glm::dvec4& place, const Point& expected) {
    CHECK(place.x == Approx(static_cast<double>(expected.x)).margin(2e-5));
    CHECK(place.y == Approx(static_cast<double>(expected.y)).margin(2e-5));
    CHECK(place.z == Approx(static_cast<double>(expected.z)).margin(2e-5));
    CHECK(place.w == Approx(static_cast<double>(expected.w)).margin(2e-5));
}

bool is_same(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(a, b) < 1e-12;
}

} // namespace space_chain_test
} // namespace

using namespace space_chain_test;

TEST_CASE("A point of the chain has the places that sums without matrices give") {
    const Scene scene = three_blocks();
    const Frame frame = prepare_frame(scene, matrix_settings(scene));
    const SpaceChain chain = space_chain(frame, block_triangle, false);
    for (int v = 0; v < 3; ++v) {
        CAPTURE(v);
        const ChainPoint& point = chain.points[chain.corners[static_cast<std::size_t>(v)]];
        REQUIRE(point.is_in_front);
        const Point& object = block[v];
        const Point world = in_world(object), camera = in_camera(world), clip = in_clip(camera);
        const Point ndc = in_ndc(clip);
        check_place(point.places[0], object);
        check_place(point.places[1], world);
        check_place(point.places[2], camera);
        check_place(point.places[3], clip);
        check_place(point.places[4], ndc);
        // In pixels a float's rounding of sine and cosine is larger.
        const Point window = in_window(ndc);
        CHECK(point.places[5].x == Approx(static_cast<double>(window.x)).margin(1e-3));
        CHECK(point.places[5].y == Approx(static_cast<double>(window.y)).margin(1e-3));
        CHECK(point.places[5].z == Approx(static_cast<double>(window.z)).margin(1e-6));
    }
}

TEST_CASE("The chain of a part has each of its edges once, and that of the scene has all parts'") {
    const Scene scene = three_blocks();
    const Frame frame = prepare_frame(scene, matrix_settings(scene));
    // Six faces of two triangles: the twelve sides of the block, and a diagonal of each face.
    const SpaceChain part = space_chain(frame, block_triangle, false);
    CHECK(part.points.size() == 8);
    CHECK(part.edges.size() == 18);
    CHECK(part.is_complete);
    CHECK(std::count_if(part.edges.begin(), part.edges.end(),
                        [](const ChainEdge& edge) { return edge.is_of_triangle; }) == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(part.edges[i].is_of_triangle);
    const SpaceChain whole = space_chain(frame, block_triangle, true);
    CHECK(whole.points.size() == 4 + 3 * 8);
    CHECK(whole.edges.size() == 5 + 3 * 18);
    Settings painter = matrix_settings(scene);
    set_from_text(painter, "hidden=painter");
    const Frame list = prepare_frame(scene, painter);
    for (int t = 0; t < list.triangle_count(); ++t) {
        if (scene_triangle(*list.scene, t) == block_triangle)
            CHECK(space_chain(list, t, false).edges.size() == 18);
    }
}

TEST_CASE("Resting at a space the figure has its places to scale, and in between it mixes two") {
    const Scene scene = three_blocks();
    const Frame frame = prepare_frame(scene, matrix_settings(scene));
    const SpaceChain chain = space_chain(frame, block_triangle, false);
    // Around the eight corners and the origin.
    const auto scaled = [&](const glm::dvec4& place, std::size_t space) {
        if (space == 4) return glm::dvec3(place) - glm::dvec3(0, 0, 0.5);
        if (space == 5)
            return glm::dvec3((place.x - 120) / 120, (place.y - 90) / 120, place.z - 0.5);
        double low[3] = {}, high[3] = {}, longest = 0.0;
        for (const ChainPoint& point : chain.points) {
            for (int i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], point.places[space][i]);
                high[i] = std::max(high[i], point.places[space][i]);
            }
        }
        for (int i = 0; i < 3; ++i)
            longest = std::max(longest, high[i] - low[i]);
        glm::dvec3 made;
        for (int i = 0; i < 3; ++i)
            made[i] = (place[i] - (low[i] + high[i]) / 2) / (longest / 2);
        return made;
    };
    for (const ChainPoint& point : chain.points) {
        for (std::size_t space = 0; space < chain_space_count; ++space) {
            CAPTURE(space);
            const glm::dvec3 here = scaled(point.places[space], space);
            CHECK(is_same(chain_place(chain, point, static_cast<double>(space)), here));
            if (space + 1 == chain_space_count) continue;
            const glm::dvec3 next = scaled(point.places[space + 1], space + 1);
            for (const double share : {0.25, 0.5, 0.875}) {
                CHECK(is_same(chain_place(chain, point, static_cast<double>(space) + share),
                              here * (1.0 - share) + next * share));
            }
        }
    }
}

TEST_CASE("Points at or behind w = 0 are in the figure until they would be divided") {
    const Scene scene = three_blocks();
    Settings settings = matrix_settings(scene);
    settings.camera.position = {0.0f, -0.6f, 0.2f};
    settings.camera.yaw = 0.0f;
    const Frame frame = prepare_frame(scene, settings);
    const SpaceChain floor = space_chain(frame, 0, false);
    REQUIRE(floor.points.size() == 4);
    int behind = 0;
    for (const ChainPoint& point : floor.points) {
        // The floor is 1.4 below the camera, which looks down by 0.1.
        const double w = std::cos(0.1) * (point.places[1].z - 0.2) + std::sin(0.1) * 1.4;
        CHECK(point.places[3].w == Approx(w).margin(1e-5));
        CHECK(point.is_in_front == (w > 0.0));
        behind += w > 0.0 ? 0 : 1;
        for (const double at : {0.0, 1.5, 2.0, 2.01, 3.0})
            CHECK(is_in_chain(point, at));
        for (const double at : {3.01, 4.0, 5.0})
            CHECK(is_in_chain(point, at) == (w > 0.0));
        // What is shown in clip space has fitted into it.
        const glm::dvec3 clip = glm::abs(chain_place(floor, point, 3.0));
        CHECK(std::max({clip.x, clip.y, clip.z}) <= 1.0 + 1e-9);
    }
    CHECK(behind == 2);
}

TEST_CASE("A chain has no more edges than can be drawn") {
    Scene scene;
    for (int i = 0; i < 2000; ++i) {
        const auto x = static_cast<float>(i);
        std::array<Vertex, 3> corners;
        corners[0].position = {x, 0.0f, 1.0f};
        corners[1].position = {x + 0.5f, 0.0f, 1.0f};
        corners[2].position = {x, 1.0f, 1.0f};
        scene.mesh.add_triangle_of(corners);
    }
    const Frame frame = prepare_frame(scene, matrix_settings(scene));
    const SpaceChain chain = space_chain(frame, 1999, true);
    CHECK(chain.edges.size() == most_chain_edges);
    CHECK_FALSE(chain.is_complete);
    CHECK(chain.points[0].places[0].x == 1999.0);
}

TEST_CASE("The eye of the figure sees along parallel rays, without distortion across them") {
    const glm::dvec2 x = seen_obliquely({1, 0, 0}), y = seen_obliquely({0, 1, 0}),
                     z = seen_obliquely({0, 0, 1});
    CHECK(x.x * x.x + y.x * y.x + z.x * z.x == Approx(1.0));
    CHECK(x.y * x.y + y.y * y.y + z.y * z.y == Approx(1.0));
    CHECK(x.x * x.y + y.x * y.y + z.x * z.y == Approx(0.0).margin(1e-12));
    CHECK(x.x > 0.0); // x points right, y down, and z up and to the left
    CHECK(y.y > 0.0);
    CHECK(z.x < 0.0);
    CHECK(z.y < 0.0);
}

TEST_CASE("Axes have the origin of their space, and boxes the corners of ndc and of the picture") {
    const Scene scene = three_blocks();
    const Frame frame = prepare_frame(scene, matrix_settings(scene));
    const SpaceChain chain = space_chain(frame, block_triangle, false);
    for (std::size_t space = 0; space < 4; ++space) {
        const std::vector<ChainGuide> axes = chain_guides(chain, frame, space);
        REQUIRE(axes.size() == 3);
        ChainPoint origin;
        for (int i = 0; i < 3; ++i) {
            CHECK(axes[static_cast<std::size_t>(i)].axis == i);
            CHECK(is_same(axes[static_cast<std::size_t>(i)].from,
                          chain_place(chain, origin, static_cast<double>(space))));
        }
    }
    for (const std::size_t space : {std::size_t{4}, std::size_t{5}}) {
        const double height = space == 4 ? 1.0 : 0.75;
        const std::vector<ChainGuide> box = chain_guides(chain, frame, space);
        CHECK(box.size() == 12);
        for (const ChainGuide& side : box) {
            for (const glm::dvec3& end : {side.from, side.to}) {
                CHECK(std::abs(end.x) == Approx(1.0));
                CHECK(std::abs(end.y) == Approx(height));
                CHECK(std::abs(end.z) == Approx(0.5));
            }
            // One coordinate changes along a side.
            const glm::dvec3 way = glm::abs(side.to - side.from);
            CHECK(way.x + way.y + way.z == Approx(std::max({way.x, way.y, way.z})));
        }
    }
}
