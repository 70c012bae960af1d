// The mistakes on the way from the world to the pixel, each checked against the vertices of the
// scene, in double.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "compare/compare.h"
#include "laboratory/bug_rule.h"
#include "laboratory/drawn_bug.h"
#include "picture/view_image.h"
#include "settings/setting_table.h"
#include "stages/project.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace camera_bug_tests {

/// The camera's axes in the world when it is turned by yaw alone.
struct Axes {
    glm::dvec3 right, down{0.0, 1.0, 0.0}, forward;

    explicit Axes(double yaw)
        : right(std::cos(yaw), 0.0, -std::sin(yaw)), forward(std::sin(yaw), 0.0, std::cos(yaw)) {}
    glm::dvec3 seen(const glm::dvec3& way) const {
        return {glm::dot(way, right), glm::dot(way, down), glm::dot(way, forward)};
    }
};

/// Where a place in camera space is drawn if it is divided by this number.
glm::dvec2 in_picture(const glm::dvec3& place, double divisor, const Settings& settings) {
    const double f = settings.camera.focal_length;
    return {f * place.x / divisor + settings.viewport.width / 2,
            f * place.y / divisor + settings.viewport.height / 2};
}

bool is_black(const Framebuffer& picture) {
    return std::all_of(picture.colour.begin(), picture.colour.end(),
                       [](const glm::vec3& colour) { return colour == glm::vec3(0.0f); });
}

/// Calls check(triangle, corner, vertex of the scene) for each corner that is drawn.
template <class Check>
int for_drawn_corners(const Frame& frame, Check check) {
    int count = 0;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        for (int v = 0; v < triangle_corners; ++v, ++count)
            check(t, static_cast<std::size_t>(v), frame.scene->corner(t, v));
    }
    return count;
}

TEST_CASE("B70: with the position added, the room is behind the camera") {
    const DrawnBug bug("B70");
    for (int t = 0; t < bug.wrong.triangle_count(); ++t)
        CHECK(bug.wrong.rejection(t) == Rejection::behind_camera);
    CHECK(is_black(bug.wrong_picture));
    CHECK_FALSE(is_black(bug.right_picture));
    // From the opposite side of the origin it shows what it should show from here.
    Settings opposite = bug.wrong.settings;
    opposite.camera.position = -opposite.camera.position;
    CHECK(has_same_planes(draw_frame(bug.frame_of(opposite)), bug.right_picture));
    Settings at_origin = bug.wrong.settings;
    at_origin.camera.position = glm::vec3(0.0f);
    const Framebuffer wrong = draw_frame(bug.frame_of(at_origin));
    at_origin.camera_move = CameraMove::subtracted;
    CHECK(has_same_planes(wrong, draw_frame(bug.frame_of(at_origin))));
}

TEST_CASE("B71: moved after the turn, the camera circles about the world's origin") {
    const DrawnBug bug("B71");
    const Settings& settings = bug.wrong.settings;
    const Axes axes(settings.camera.yaw);
    const glm::dvec3 position(settings.camera.position);
    const int corners =
        for_drawn_corners(bug.wrong, [&](int t, std::size_t v, const Vertex& vertex) {
            const glm::dvec3 place = axes.seen(glm::dvec3(vertex.position)) - position;
            const glm::dvec2 expected = in_picture(place, place.z, settings);
            const glm::dvec2 drawn(bug.wrong.triangle_vertices(t)[v].position);
            CHECK(glm::distance(drawn, expected) < 1e-2);
        });
    CHECK(corners > 60);
    // The same as from a camera on that circle, which looks at the origin.
    Settings on_circle = bug.right.settings;
    on_circle.camera.position =
        glm::vec3(position.x * axes.right + position.y * axes.down + position.z * axes.forward);
    const Frame seen = bug.frame_of(on_circle);
    for_drawn_corners(seen, [&](int t, std::size_t v, const Vertex&) {
        const glm::vec2 there = seen.triangle_vertices(t)[v].position;
        CHECK(glm::distance(there, bug.wrong.triangle_vertices(t)[v].position) < 1e-2f);
    });
    CHECK(pixel_difference(bug.wrong_picture, bug.right_picture).different > 50000);
    Settings straight = settings;
    straight.camera.yaw = 0.0f;
    const Framebuffer wrong = draw_frame(bug.frame_of(straight));
    straight.camera_move = CameraMove::subtracted;
    CHECK(has_same_planes(wrong, draw_frame(bug.frame_of(straight))));
}

TEST_CASE("B72: a step along z moves what is straight ahead to the right") {
    const DrawnBug bug("B72");
    const double yaw = bug.right.settings.camera.yaw;
    const Axes axes(yaw);
    const glm::dvec3 start(default_settings(*bug.session.scene).camera.position);
    const glm::dvec3 right = glm::dvec3(bug.right.settings.camera.position) - start;
    const glm::dvec3 wrong = glm::dvec3(bug.wrong.settings.camera.position) - start;
    CHECK(glm::distance(right, axes.forward) < 1e-4);
    CHECK(glm::distance(wrong, glm::dvec3(0.0, 0.0, 1.0)) < 1e-4);
    const auto column_of_middle = [&](const Frame& frame) {
        Vertex ahead;
        ahead.position = glm::vec3(start + 5.0 * axes.forward);
        const ShadedVertex shaded =
            shade_vertex(ahead, camera_rotation(frame.settings.camera),
                         vertex_rules(frame.settings, SceneSpace::world), frame.stages);
        return double{shaded.pixel.position.x};
    };
    CHECK(column_of_middle(bug.right) == Approx(250.0).margin(0.1));
    const glm::dvec3 seen = axes.seen(5.0 * axes.forward - glm::dvec3(0.0, 0.0, 1.0));
    CHECK(column_of_middle(bug.wrong) ==
          Approx(in_picture(seen, seen.z, bug.wrong.settings).x).margin(0.1));
    CHECK(column_of_middle(bug.wrong) > 290.0);
    // Not a rule of the program: neither a quiz nor a diagnosis can know where the camera should
    // be.
    for (const Bug& one : read_bugs())
        CHECK(changes_rule(one) == (one.id != "B72"));
}

TEST_CASE("B73: columns and rows are swapped") {
    const DrawnBug bug("B73");
    for (const Viewport& size : {Viewport{500, 500}, Viewport{300, 200}}) {
        Settings settings = bug.wrong.settings;
        settings.viewport = size;
        const Frame wrong = bug.frame_of(settings);
        settings.image_axes = ImageAxes::right_way;
        const Frame right = bug.frame_of(settings);
        const int corners = for_drawn_corners(right, [&](int t, std::size_t v, const Vertex&) {
            const ScreenVertex &a = wrong.triangle_vertices(t)[v],
                               &b = right.triangle_vertices(t)[v];
            CHECK(a.column - size.width / 2 == b.row - size.height / 2);
            CHECK(a.row - size.height / 2 == b.column - size.width / 2);
            CHECK(a.inv_w == b.inv_w);
        });
        CHECK(corners == 90);
    }
    // The floor is green, and below the middle; here it is to the right of it.
    const glm::vec3 floor(0.15f, 0.75f, 0.15f);
    CHECK(bug.right_picture.colour[bug.right_picture.at(250, 490)] == floor);
    CHECK(bug.wrong_picture.colour[bug.wrong_picture.at(490, 250)] == floor);
}

TEST_CASE("B74: the upper left quarter shows the lower right one, and the rest is black") {
    const DrawnBug bug("B74");
    for_drawn_corners(bug.right, [&](int t, std::size_t v, const Vertex&) {
        const ScreenVertex &a = bug.wrong.triangle_vertices(t)[v],
                           &b = bug.right.triangle_vertices(t)[v];
        CHECK(a.column == b.column - 250);
        CHECK(a.row == b.row - 250);
    });
    int other = 0;
    for (int row = 0; row < 500; ++row) {
        for (int column = 0; column < 500; ++column) {
            const std::int32_t owner = bug.wrong_picture.owner[bug.wrong_picture.at(column, row)];
            const bool is_in_quarter = column < 250 && row < 250;
            if (!is_in_quarter) {
                if (owner != -1) FAIL("pixel " << column << ", " << row);
                continue;
            }
            // Elsewhere, steps of edges are rounded differently.
            const std::size_t there = bug.right_picture.at(column + 250, row + 250);
            other += owner != bug.right_picture.owner[there] ? 1 : 0;
        }
    }
    CHECK(other < 250 * 250 / 100);
}

TEST_CASE("B75: vertices are divided by their distance, and the room no longer fills the picture") {
    const DrawnBug bug("B75");
    const Settings& settings = bug.wrong.settings;
    const glm::dvec3 camera(settings.camera.position);
    const glm::dvec2 middle(250.0);
    const int corners =
        for_drawn_corners(bug.wrong, [&](int t, std::size_t v, const Vertex& vertex) {
            const glm::dvec3 place = glm::dvec3(vertex.position) - camera;
            const double distance = glm::length(place);
            const ScreenVertex& drawn = bug.wrong.triangle_vertices(t)[v];
            const glm::dvec2 position(drawn.position);
            CHECK(glm::distance(position, in_picture(place, distance, settings)) < 1e-2);
            CHECK(double{drawn.inv_w} == Approx(1.0 / distance));
            CHECK(double{drawn.depth} == Approx(1.0 / distance));
            const glm::dvec2 right = in_picture(place, place.z, settings);
            CHECK(glm::distance(position, middle) < glm::distance(right, middle));
        });
    CHECK(corners == 90);
    // All around it is black: the room ends where its nearest corners are.
    for (int i = 0; i < 500; ++i) {
        for (const glm::ivec2& pixel :
             {glm::ivec2(i, 2), glm::ivec2(i, 497), glm::ivec2(2, i), glm::ivec2(497, i)})
            CHECK(bug.wrong_picture.owner[bug.wrong_picture.at(pixel.x, pixel.y)] == -1);
    }
    // Triangles behind the camera are still left out.
    Settings inside = settings;
    inside.camera.position = glm::vec3(0.0f);
    const Frame wrong = bug.frame_of(inside);
    inside.divided_by = DividedBy::z;
    const Frame right = bug.frame_of(inside);
    int behind = 0;
    for (int t = 0; t < right.triangle_count(); ++t) {
        CHECK(wrong.rejection(t) == right.rejection(t));
        behind += right.rejection(t) == Rejection::behind_camera ? 1 : 0;
    }
    CHECK(behind > 0);
}

TEST_CASE("B79: red and blue are swapped on the screen only") {
    const DrawnBug bug("B79");
    CHECK(has_same_planes(bug.wrong_picture, bug.right_picture));
    const Image wrong = view_image(bug.wrong_picture, View::colour);
    const Image right = view_image(bug.right_picture, View::colour);
    std::int64_t changed = 0;
    for (std::size_t i = 0; i < wrong.rgba.size(); i += 4) {
        const bool is_swapped = wrong.rgba[i] == right.rgba[i + 2] &&
                                wrong.rgba[i + 1] == right.rgba[i + 1] &&
                                wrong.rgba[i + 2] == right.rgba[i];
        if (!is_swapped) FAIL("pixel " << i / 4);
        changed += right.rgba[i] != right.rgba[i + 2] ? 1 : 0;
    }
    CHECK(changed > 50000);
    CHECK(changed < 250000);
    const PixelDifference difference = pixel_difference(bug.wrong_picture, bug.right_picture);
    CHECK(difference.different == changed);
    CHECK(difference.shown == changed);
    // In another view of the picture the channels are not colours of the scene.
    CHECK(view_image(bug.wrong_picture, View::depth).rgba ==
          view_image(bug.right_picture, View::depth).rgba);
}

} // namespace camera_bug_tests
} // namespace
