// The eye outside, compared with the stages, which project in a different way.

#include "outside/outside_eye.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/frame.h"
#include "settings/settings.h"
#include "stages/project.h"
#include "stages/stage_table.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

OutsideScene outside_scene_of(const Scene& scene, const Camera& camera, const Viewport& viewport) {
    OutsideScene outside_scene;
    outside_scene.box = box_of(scene);
    outside_scene.plane = picture_plane(camera, viewport, outside_scene.box);
    outside_scene.lamp = scene.light.position;
    return outside_scene;
}

/// By the stages: pixels from the picture's corner, before rounding; none behind the camera.
std::optional<glm::dvec2> projected(const glm::vec3& world, const Camera& camera,
                                    const Viewport& viewport) {
    Vertex vertex;
    vertex.position = world;
    VertexRules rules;
    rules.camera = camera;
    rules.viewport = viewport;
    const ShadedVertex shaded = shade_vertex(vertex, camera_rotation(camera), rules, Stages());
    if (!shaded.has_pixel) return std::nullopt;
    return glm::dvec2(shaded.in("projected")) + glm::dvec2(viewport_middle(rules));
}

bool is_near(const glm::dvec2& a, const glm::dvec2& b, double distance) {
    return glm::length(a - b) <= distance;
}

Camera any_camera(Random& random) {
    Camera camera;
    camera.position = {random.number(-2, 2), random.number(-2, 2), random.number(-5, 0)};
    camera.yaw = random.number(-4, 4);
    camera.pitch = random.number(-1.5, 1.5);
    camera.focal_length = random.number(100, 900);
    return camera;
}

glm::vec3 any_place(Random& random) {
    return {random.number(-2, 2), random.number(-2, 2), random.number(-2, 2)};
}

} // namespace

TEST_CASE("Through the camera, every vertex falls on the same pixel as in the picture, to scale") {
    Random random(51);
    const Scene room = lab_room();
    for (int i = 0; i < rounds(300, 50); ++i) {
        const Camera camera = any_camera(random);
        const Viewport viewport{random.integer(1, 700), random.integer(1, 700)};
        const glm::ivec2 size(random.integer(50, 1500), random.integer(50, 1500));
        const OutsideScene outside_scene = outside_scene_of(room, camera, viewport);
        OutsideView view;
        view.is_camera = true;
        const OutsideEye eye = eye_of(view, outside_scene, size, 20.0);
        const double scale = eye.focal_length / static_cast<double>(camera.focal_length);
        // The picture is in the middle, and all of it is seen.
        const glm::dvec2 corner =
            0.5 * glm::dvec2(size) - 0.5 * scale * glm::dvec2(viewport.width, viewport.height);
        CHECK(corner.x >= 0.0);
        CHECK(corner.y >= 0.0);
        for (int k = 0; k < 20; ++k) {
            const glm::vec3 place = any_place(random);
            const std::optional<glm::dvec2> pixel = projected(place, camera, viewport);
            const std::optional<glm::dvec2> seen = eye.pixel_of(place);
            if (!pixel || !seen) continue;
            const double distance = 1e-4 * (1.0 + glm::length(*seen));
            REQUIRE(is_near(*seen, corner + scale * *pixel, distance));
        }
    }
}

TEST_CASE("Through the camera, the view of a box is as large as fits, whatever its shape") {
    Random random(55);
    const Scene room = lab_room();
    int compared = 0;
    for (int i = 0; i < rounds(200, 50); ++i) {
        Settings settings = default_settings(room);
        settings.transform = Transform::matrices;
        settings.near = random.number(0.05, 1);
        settings.viewport = {random.integer(1, 700), random.integer(1, 700)};
        const float left = random.number(-1, 0.5), bottom = random.number(-1, 0.5);
        settings.view_box =
            ViewBox{left, left + random.number(0.1, 2), bottom, bottom + random.number(0.1, 2)};
        const Frame frame = prepare_frame(room, settings);
        OutsideScene outside_scene = outside_scene_of(room, settings.camera, settings.viewport);
        outside_scene.plane = picture_plane(settings.camera, settings.viewport, outside_scene.box,
                                            vertex_rules(settings, room.space).projection);
        const glm::ivec2 size(random.integer(100, 1500), random.integer(100, 1500));
        OutsideView view;
        view.is_camera = true;
        const OutsideEye eye = eye_of(view, outside_scene, size, 20.0);
        // A window as wide to its height as the box, in the middle, which touches two borders.
        const ViewBox& box = *settings.view_box;
        const glm::dvec2 sides_of_box =
            glm::dvec2(box.right, box.top) - glm::dvec2(box.left, box.bottom);
        const glm::dvec2 shown = sides_of_box * (eye.focal_length / settings.near);
        const glm::dvec2 room_for = 0.98 * (glm::dvec2(size) - 40.0);
        CAPTURE(i);
        CHECK(shown.x <= room_for.x + 1e-6);
        CHECK(shown.y <= room_for.y + 1e-6);
        CHECK(std::min(room_for.x - shown.x, room_for.y - shown.y) < 1e-3);
        for (int t = 0; t < room.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            for (int v = 0; v < 3; ++v) {
                const glm::dvec2 drawn(
                    frame.triangle_vertices(t)[static_cast<std::size_t>(v)].position);
                const glm::dvec2 sides(settings.viewport.width, settings.viewport.height);
                const auto seen = eye.pixel_of(glm::dvec3(room.corner(t, v).position));
                REQUIRE(seen);
                const glm::dvec2 expected = 0.5 * glm::dvec2(size) + (drawn / sides - 0.5) * shown;
                CHECK(is_near(*seen, expected, 1e-3 * (1.0 + glm::length(expected))));
                ++compared;
            }
        }
    }
    CHECK(compared > 1000);
}

TEST_CASE("The corners of the picture lie on the rays through its corners") {
    Random random(52);
    const Scene room = lab_room();
    for (int i = 0; i < rounds(300, 50); ++i) {
        const Camera camera = any_camera(random);
        const Viewport viewport{random.integer(1, 900), random.integer(1, 900)};
        const PicturePlane plane = picture_plane(camera, viewport, box_of(room));
        const std::array<glm::dvec3, 4> corners = plane.corners();
        const double width = viewport.width, height = viewport.height;
        const std::array<glm::dvec2, 4> pixels{
            glm::dvec2{0, 0}, {width, 0}, {width, height}, {0, height}};
        for (std::size_t c = 0; c < 4; ++c) {
            // Any place on the ray is projected to the same pixel.
            const double along = random.real(0.5, 4.0);
            const glm::vec3 place = plane.eye + along * (corners[c] - plane.eye);
            const std::optional<glm::dvec2> pixel = projected(place, camera, viewport);
            REQUIRE(pixel);
            CHECK(is_near(*pixel, pixels[c], 0.02));
            const std::optional<glm::dvec2> own = plane.pixel_of(plane.in_camera(corners[c]));
            REQUIRE(own);
            CHECK(is_near(*own, pixels[c], 1e-3));
        }
    }
}

TEST_CASE("Under every projection the rays of the drawing go through the pane") {
    Random random(54);
    const Scene room = lab_room();
    for (int i = 0; i < rounds(60, 20); ++i) {
        Settings settings;
        settings.camera.position = {random.number(-1, 1), random.number(-1, 1),
                                    random.number(-5, -2)};
        settings.camera.yaw = random.number(-0.4, 0.4);
        settings.camera.focal_length = random.number(100, 900);
        settings.viewport = {random.integer(1, 900), random.integer(1, 900)};
        settings.projection_mix = i % 2 == 0 ? 1.0f : random.number(0, 1);
        if (i % 3 == 0) {
            settings.transform = Transform::matrices;
            settings.view_box = ViewBox{-random.number(0.05, 1), random.number(0.05, 1),
                                        -random.number(0.05, 1), random.number(0.05, 1)};
        }
        const Frame frame = prepare_frame(room, settings);
        const PicturePlane plane = picture_plane(settings.camera, settings.viewport, box_of(room),
                                                 vertex_rules(settings, room.space).projection);
        for (int t = 0; t < room.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            for (int v = 0; v < 3; ++v) {
                const glm::dvec3 seen = plane.in_camera(glm::dvec3(room.corner(t, v).position));
                const glm::dvec2 drawn(
                    frame.triangle_vertices(t)[static_cast<std::size_t>(v)].position);
                const std::optional<glm::dvec2> pixel = plane.pixel_of(seen);
                REQUIRE(pixel);
                CHECK(is_near(*pixel, drawn, 0.05));
                // Where the ray goes through the pane, the picture has that place too.
                const glm::dvec3 crossing = plane.in_world(plane.on_ray(seen, plane.distance));
                CHECK(glm::distance(plane.place_of(*pixel), crossing) < 1e-6);
                // Orthographic rays are parallel to the camera's direction.
                if (settings.projection_mix == 1.0f)
                    CHECK(is_near(glm::dvec2(plane.on_ray(seen, 0.0)), glm::dvec2(seen), 1e-9));
            }
        }
    }
}

TEST_CASE("A view that has no distance yet shows everything as large as possible") {
    Random random(53);
    const Scene room = lab_room();
    for (int i = 0; i < rounds(400, 60); ++i) {
        const OutsideScene outside_scene = outside_scene_of(room, any_camera(random), {400, 300});
        const glm::ivec2 size(random.integer(100, 1500), random.integer(100, 1500));
        const double margin = random.real(0.0, 30.0);
        OutsideView view;
        view.yaw = random.number(-4, 4);
        view.pitch = random.number(-1.57, 1.57);
        const OutsideEye eye = eye_of(view, outside_scene, size, margin);
        std::vector<glm::dvec3> places;
        for (const Vertex& vertex : room.mesh.vertices())
            places.emplace_back(vertex.position);
        for (const glm::dvec3& corner : outside_scene.plane.corners())
            places.push_back(corner);
        places.push_back(outside_scene.plane.eye);
        places.push_back(outside_scene.lamp);
        // The distance of the outermost place from the border.
        double nearest = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& place : places) {
            const std::optional<glm::dvec2> at = eye.pixel_of(place);
            REQUIRE(at);
            nearest = std::min({nearest, at->x, at->y, size.x - at->x, size.y - at->y});
        }
        CHECK(nearest > margin - 0.5);
        CHECK(nearest < margin + 1.0);
        // The same view with all its numbers set.
        const OutsideEye again =
            eye_of(settled(view, outside_scene, size, margin), outside_scene, size, margin);
        CHECK(glm::length(again.position - eye.position) < 1e-5);
    }
}

TEST_CASE("After leaving the camera's view the eye outside looks the same way") {
    Random random(54);
    const Scene room = lab_room();
    for (int i = 0; i < 50; ++i) {
        const Camera camera = any_camera(random);
        const OutsideScene outside_scene = outside_scene_of(room, camera, {400, 300});
        OutsideView view;
        view.is_camera = true;
        const OutsideView outside = settled(view, outside_scene, {800, 600}, 20.0);
        CHECK_FALSE(outside.is_camera);
        CHECK(outside.distance > 0.0f);
        const OutsideEye eye = eye_of(outside, outside_scene, {800, 600}, 20.0);
        CHECK(glm::length(eye.rotation[2] - outside_scene.plane.rotation[2]) < 1e-5);
    }
}

TEST_CASE("A drag across the view moves the target along") {
    const Scene room = lab_room();
    const glm::ivec2 size(800, 600);
    const OutsideScene outside_scene = outside_scene_of(room, room.camera, room.viewport);
    const OutsideView view = settled({}, outside_scene, size, 10.0);
    const OutsideEye eye = eye_of(view, outside_scene, size, 10.0);
    const OutsideEye moved = eye_of(shifted(view, eye, {30.0f, -20.0f}), outside_scene, size, 10.0);
    const std::optional<glm::dvec2> at = moved.pixel_of(view.target);
    REQUIRE(at);
    CHECK(is_near(*at, {430.0, 280.0}, 0.01));
}

TEST_CASE("No camera, scene or size makes an eye without a place") {
    Scene empty;
    Scene odd = lab_room();
    Vertex vertex;
    vertex.position = {std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f};
    odd.mesh.add_vertex(vertex);
    vertex.position = {1e6f, -1e6f, std::numeric_limits<float>::infinity()};
    odd.mesh.add_vertex(vertex);
    vertex.position = glm::vec3(1e6f);
    odd.mesh.add_vertex(vertex);
    for (const Scene& scene : {empty, odd}) {
        for (const float focal : {1e-6f, 1.0f, 1e5f}) {
            for (const float place : {0.0f, 1000.0f, 1e30f}) {
                for (const glm::ivec2 size : {glm::ivec2(0, 0), {1, 1}, {3000, 1}, {500, 500}}) {
                    Camera camera;
                    camera.position = glm::vec3(place);
                    camera.focal_length = focal;
                    const OutsideScene outside_scene = outside_scene_of(scene, camera, {4096, 1});
                    for (const bool is_camera : {false, true}) {
                        OutsideView view;
                        view.is_camera = is_camera;
                        const OutsideEye eye = eye_of(view, outside_scene, size, 40.0);
                        const double sum = eye.position.x + eye.position.y + eye.position.z +
                                           eye.focal_length + eye.near_distance;
                        CHECK(std::isfinite(sum));
                        CHECK(eye.near_distance > 0.0);
                        CHECK(eye.focal_length > 0.0);
                    }
                }
            }
        }
    }
}
