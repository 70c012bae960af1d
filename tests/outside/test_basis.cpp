// The axes of spaces in the view from outside, compared with matrices computed by hand.

#include "outside/basis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <glm/geometric.hpp>

#include "lessons/lesson_run.h"
#include "outside/outside_marks.h"
#include "outside/picture_plane.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/matrices.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Settings by_matrices(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.transform = Transform::matrices;
    return settings;
}

const Basis* find_basis(const std::vector<Basis>& bases, BasisOf of) {
    const auto found =
        std::find_if(bases.begin(), bases.end(), [&](const Basis& b) { return b.of == of; });
    return found == bases.end() ? nullptr : &*found;
}

/// The first triangle of the part with this name.
int first_of_part(const Scene& scene, const std::string& name) {
    for (int t = 0; t < scene.triangle_count(); ++t) {
        if (part_name(scene, t) == name) return t;
    }
    FAIL("no part " << name);
    return -1;
}

void check_axes(const Basis& basis, const glm::dvec3& origin, const glm::dvec3& x,
                const glm::dvec3& y, const glm::dvec3& z) {
    CHECK(glm::distance(basis.origin, origin) < 1e-6);
    CHECK(glm::distance(basis.axes[0], x) < 1e-6);
    CHECK(glm::distance(basis.axes[1], y) < 1e-6);
    CHECK(glm::distance(basis.axes[2], z) < 1e-6);
}

} // namespace

TEST_CASE("The world's axes are plain, and the camera's are the rows of its matrix") {
    const Scene room = lab_room();
    Settings settings = by_matrices(room);
    for (const bool looks_at : {false, true}) {
        settings.camera.position = {0.5f, -0.6f, -2.5f};
        settings.camera.yaw = 0.3f;
        settings.camera.pitch = -0.2f;
        if (looks_at) settings.camera.aim = CameraAim::look_at;
        settings.camera.target = {0.3f, 0.4f, -0.4f};
        const std::vector<Basis> bases = bases_of(prepare_frame(room, settings), 3);
        REQUIRE(bases.size() == 2);
        const Basis* const world = find_basis(bases, BasisOf::world);
        const Basis* const camera = find_basis(bases, BasisOf::camera);
        REQUIRE(world);
        REQUIRE(camera);
        check_axes(*world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
        const glm::dvec3 eye(settings.camera.position);
        // A second way: from angles by sine and cosine, or from the target by cross products.
        const double yaw = 0.3, pitch = -0.2;
        const glm::dvec3 forward =
            looks_at ? glm::normalize(glm::dvec3(settings.camera.target) - eye)
                     : glm::dvec3(std::cos(pitch) * std::sin(yaw), -std::sin(pitch),
                                  std::cos(pitch) * std::cos(yaw));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward));
        check_axes(*camera, eye, right, glm::cross(forward, right), forward);
        // Tv takes the tips to one unit along each axis of camera space.
        const glm::dmat4 view = view_matrix(eye, glm::dmat3(camera_rotation(settings.camera)));
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3& axis = camera->axes[static_cast<std::size_t>(i)];
            const glm::dvec4 tip = view * glm::dvec4(camera->origin + axis, 1.0);
            glm::dvec4 expected(0.0, 0.0, 0.0, 1.0);
            expected[i] = 1.0;
            CHECK(glm::distance(tip, expected) < 1e-6);
            for (int k = 0; k < 3; ++k)
                CHECK(view[k][i] == Approx(axis[k]).margin(1e-6));
        }
    }
}

TEST_CASE("A model's axes are the first columns of Tm, and its origin is the last") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/turned-block.toml");
    const Frame frame = prepare_frame(scene, by_matrices(scene));
    const auto model_of = [&](const std::string& part) {
        const std::vector<Basis> bases = bases_of(frame, first_of_part(scene, part));
        const Basis* const found = find_basis(bases, BasisOf::object);
        REQUIRE(found);
        return *found;
    };
    check_axes(model_of("block as it is made"), {-1.5, 0.3, 0.4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    check_axes(model_of("mirrored"), {1.5, 0.3, 0.4}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    // Scaled by (1, 1.5, 0.6), turned by 0.7 from z toward x, then moved.
    const double c = std::cos(0.7), s = std::sin(0.7);
    check_axes(model_of("turned and scaled"), {0, 0.05, 0.4}, {c, 0, -s}, {0, 1.5, 0},
               {0.6 * s, 0, 0.6 * c});
    // The floor has no steps, so its axes would coincide with the world's.
    CHECK(bases_of(frame, first_of_part(scene, "floor")).size() == 2);
}

TEST_CASE("Axes exist only with matrices, and not in scenes in pixels") {
    const Scene room = lab_room();
    CHECK(bases_of(prepare_frame(room, default_settings(room)), 3).empty());
    CHECK(bases_of(prepare_frame(room, by_matrices(room)), std::nullopt).size() == 2);
    CHECK(bases_of(prepare_frame(room, by_matrices(room)), 9999).size() == 2);
    CHECK(bases_of(prepare_frame(room, by_matrices(room)), -1).size() == 2);
    const Scene pixels = read_scene(lessons_folder() + "/scenes/one-triangle.toml");
    CHECK(bases_of(prepare_frame(pixels, by_matrices(pixels)), 0).empty());
}

TEST_CASE("An arrow goes from the origin of a space to its axis's tip, and is named there") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/turned-block.toml");
    const int triangle = first_of_part(scene, "turned and scaled");
    const Frame frame = prepare_frame(scene, by_matrices(scene));
    const std::vector<Basis> bases = bases_of(frame, triangle);
    REQUIRE(bases.size() == 3);
    OutsideScene outside_scene;
    outside_scene.box = box_of(scene);
    outside_scene.plane = picture_plane(scene.camera, scene.viewport, outside_scene.box);
    outside_scene.lamp = scene.light.position;
    const glm::ivec2 size(900, 700);
    const OutsideEye eye = eye_of({}, outside_scene, size, 40.0);
    const auto marks_with = [&](std::span<const Basis> some) {
        return outside_marks(scene, outside_scene, eye, {triangle}, std::nullopt, size,
                             {.bases = some});
    };
    const OutsideMarks marks = marks_with(bases), plain = marks_with({});
    const auto is_axis = [](const auto& mark) { return mark.kind == decltype(mark.kind)::axis; };
    CHECK(std::none_of(plain.lines.begin(), plain.lines.end(), is_axis));
    CHECK(std::none_of(plain.points.begin(), plain.points.end(), is_axis));
    CHECK(marks.lines.size() == plain.lines.size() + 9);
    for (const Basis& basis : bases) {
        const auto from = eye.pixel_of(basis.origin);
        REQUIRE(from);
        const auto origin =
            std::find_if(marks.points.begin(), marks.points.end(), [&](const OutsidePoint& p) {
                return p.kind == OutsidePointKind::origin && p.number == static_cast<int>(basis.of);
            });
        REQUIRE(origin != marks.points.end());
        CHECK(glm::distance(origin->at, glm::vec2(*from)) < 0.01f);
        for (int i = 0; i < 3; ++i) {
            INFO(word_of(basis.of) << " axis " << i);
            const int number = axis_number(basis.of, i);
            const auto tip = eye.pixel_of(basis.origin + basis.axes[static_cast<std::size_t>(i)]);
            REQUIRE(tip);
            const auto line =
                std::find_if(marks.lines.begin(), marks.lines.end(), [&](const OutsideLine& l) {
                    return l.kind == OutsideLineKind::axis && l.number == number;
                });
            REQUIRE(line != marks.lines.end());
            CHECK(glm::distance(line->from, glm::vec2(*from)) < 0.01f);
            CHECK(glm::distance(line->to, glm::vec2(*tip)) < 0.01f);
            const auto point =
                std::find_if(marks.points.begin(), marks.points.end(), [&](const OutsidePoint& p) {
                    return p.kind == OutsidePointKind::axis && p.number == number;
                });
            REQUIRE(point != marks.points.end());
            CHECK(glm::distance(point->at, glm::vec2(*tip)) < 0.01f);
        }
    }
}

TEST_CASE("A surface with a normal map shows tangent, bitangent and normal, in a mirror too") {
    const Scene boards = read_scene(lessons_folder() + "/scenes/studs.toml");
    Settings settings = default_settings(boards);
    const auto surface_of_triangle = [&](int triangle) {
        const std::vector<Basis> bases = bases_of(prepare_frame(boards, settings), triangle);
        const Basis* const found = find_basis(bases, BasisOf::surface);
        return found != nullptr ? std::optional<Basis>(*found) : std::nullopt;
    };
    // The arrows are a third of the mean of the sides, 0.9 and 0.9.
    const auto left = surface_of_triangle(0), mirrored = surface_of_triangle(3);
    REQUIRE(left);
    REQUIRE(mirrored);
    CHECK(glm::distance(left->origin, {-0.66, -0.15, 2.0}) < 1e-6);
    CHECK(glm::distance(left->axes[0], {0.3, 0, 0}) < 1e-6);
    CHECK(glm::distance(left->axes[1], {0, -0.3, 0}) < 1e-6);
    CHECK(glm::distance(left->axes[2], {0, 0, -0.3}) < 1e-6);
    CHECK(glm::normalize(mirrored->axes[0]).x == Approx(-1.0));
    CHECK(glm::normalize(mirrored->axes[1]).y == Approx(-1.0));
    settings.normal_map_rule = NormalMapRule::mirror_missed;
    CHECK(glm::normalize(surface_of_triangle(3)->axes[1]).y == Approx(1.0));
    for (const int none : {-1, 9999})
        CHECK_FALSE(surface_of_triangle(none));
    settings.normal_map = NormalMapUse::off;
    CHECK_FALSE(surface_of_triangle(0));
    CHECK(bases_of(prepare_frame(boards, settings), std::nullopt).empty());
}
