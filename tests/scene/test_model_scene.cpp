// A model as a scene: where its points, normals and texture coordinates end up, and whether the
// camera sees all of it, projected here a second time, in double.

#include "scene/model_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Scene scene_of_text(const std::string& text) {
    return scene_of_model(parse_obj(text, "folder/thing.obj"));
}

/// How far from the middle of the picture a point is seen, as a part of the way to its edge; more
/// than 1 is outside. The camera turns by yaw, then by pitch, as in the lab.
double distance_from_middle(const Scene& scene, const glm::vec3& point) {
    const double yaw = scene.camera.yaw, pitch = scene.camera.pitch;
    const glm::dvec3 p = glm::dvec3(point) - glm::dvec3(scene.camera.position);
    const double x = std::cos(yaw) * p.x - std::sin(yaw) * p.z;
    const double ahead = std::sin(yaw) * p.x + std::cos(yaw) * p.z;
    const double y = std::cos(pitch) * p.y + std::sin(pitch) * ahead;
    const double z = std::cos(pitch) * ahead - std::sin(pitch) * p.y;
    const double f = scene.camera.focal_length;
    return z <= 0.1 ? INFINITY
                    : std::max(std::abs(f * x / z) / (0.5 * scene.viewport.width),
                               std::abs(f * y / z) / (0.5 * scene.viewport.height));
}

} // namespace

TEST_CASE("A model is in the middle of its scene, turned so that up is up") {
    // A box from (10, 20, 30) to (14, 21, 32): its longest side, of 4, becomes 2.
    const Scene scene = scene_of_text("v 10 20 30\nv 14 20 30\nv 14 21 32\n"
                                      "vt 0.25 0.75\nvn 0 1 0\nf 1/1/1 2/1/1 3/1/1\n");
    CHECK(scene.name == "thing");
    CHECK(scene.path == "folder/thing.obj");
    CHECK(scene.space == SceneSpace::world);
    REQUIRE(scene.triangle_count() == 1);
    // Corners 1 and 2 have changed places.
    CHECK(scene.corner(0, 0).position == glm::vec3(-1, 0.25f, 0.5f));
    CHECK(scene.corner(0, 1).position == glm::vec3(1, -0.25f, -0.5f));
    CHECK(scene.corner(0, 2).position == glm::vec3(1, 0.25f, 0.5f));
    CHECK(scene.corner(0, 0).normal == glm::vec3(0, -1, 0));
    CHECK(scene.corner(0, 0).texcoord == glm::vec2(0.25f, 0.25f));
    REQUIRE(scene.parts.size() == 1);
    CHECK(scene.parts[0].name == "thing");
    REQUIRE(scene.parts[0].model.positions.size() == 3);
    CHECK(scene.parts[0].model.positions[1] == glm::vec3(14, 21, 32));
    REQUIRE(scene.model_report);
    CHECK(scene.model_report->counts.triangles == 1);
}

TEST_CASE("The fronts of a model are those of a scene") {
    // Seen from where z points, 1 2 3 go round counterclockwise.
    const Scene scene = scene_of_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const glm::vec3 normal = face_normal(scene.corner(0, 0).position, scene.corner(0, 1).position,
                                         scene.corner(0, 2).position);
    CHECK(normal == glm::vec3(0, 0, -1)); // toward the camera
    CHECK(scene.corner(0, 0).normal == normal);
}

TEST_CASE("The camera sees the whole model and comes near, whatever its shape and size") {
    const std::string faces = "f 1 2 3\nf 4 2 3\n";
    for (const std::string points :
         {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "v 0 0 0\nv 1e8 0 0\nv 0 3e8 0\nv 0 0 9e8\n",
          "v 0 0 0\nv 1e-4 0 0\nv 0 1e-4 0\nv 0 0 1e-4\n",
          "v -7 0 0\nv 7 0 0\nv 0 0.001 0\nv 0 0 0\n", "v 0 -7 0\nv 0 7 0\nv 0 0 0\nv 0 1 0\n",
          "v 5e6 5e6 0\nv 5000010 5e6 0\nv 5e6 5000010 0\nv 5e6 5e6 10\n"}) {
        INFO(points);
        const Scene scene = scene_of_text(points + faces);
        double farthest = 0.0;
        glm::vec3 least(1e9f), most(-1e9f);
        for (const Vertex& vertex : scene.mesh.vertices()) {
            farthest = std::max(farthest, distance_from_middle(scene, vertex.position));
            least = glm::min(least, vertex.position);
            most = glm::max(most, vertex.position);
        }
        CHECK(farthest <= 0.9001);
        const glm::vec3 side = most - least;
        CHECK(std::max({side.x, side.y, side.z}) == Approx(2.0f));
        // One corner of the box touches the border of nine tenths.
        double touched = 0.0;
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 corner((i & 1) != 0 ? most.x : least.x, (i & 2) != 0 ? most.y : least.y,
                                   (i & 4) != 0 ? most.z : least.z);
            touched = std::max(touched, distance_from_middle(scene, corner));
        }
        CHECK(touched == Approx(0.9).margin(1e-3));
    }
}

TEST_CASE("A model that is a single point has a scene with places that are numbers") {
    const Scene scene = scene_of_text("v 4 5 6\nf 1 1 1\n");
    CHECK(scene.corner(0, 2).position == glm::vec3(0));
    CHECK(glm::length(scene.camera.position) == Approx(0.5f));
    CHECK(scene.light.power.x > 0.0f);
    CHECK(scene.light.power.x < largest_power);
}

TEST_CASE("A model is opened where a scene is, by its ending") {
    const Scene scene = read_scene_file(lessons_folder() + "/models/teapot.obj");
    CHECK(scene.name == "teapot");
    REQUIRE(scene.parts.size() == 4);
    CHECK(scene.parts[0].name == "body");
    CHECK(scene.corner(0, 0).reflectance == glm::vec3(0.75f, 0.35f, 0.2f));
    CHECK(scene.corner(0, 0).shine == Shine{glm::vec3(0.5f), 40.0f});
    CHECK(scene.corner(scene.parts[1].first_triangle, 0).reflectance ==
          glm::vec3(0.2f, 0.45f, 0.55f));
    CHECK_THROWS_AS(read_scene_file("/nowhere/at/all.obj"), AccessError);
}
