// The predictions and figures of lessons 15 and 16: each answer that the program computes from its
// facts is found here a second time, in double, with matrices that are written out by hand.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "pipeline/draw.h"
#include "scene/look_at.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/matrices.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "support/quoted_text.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace spaces_track {

/// Rows of a matrix, and a column to multiply them with: nothing of the program, nothing of glm.
using Column = std::array<double, 4>;
using Rows = std::array<Column, 4>;

Column times(const Rows& m, const Column& v) {
    Column sum{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            sum[i] += m[i][k] * v[k];
    }
    return sum;
}

Rows product(const Rows& a, const Rows& b) {
    Rows result{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t k = 0; k < 4; ++k)
                result[i][j] += a[i][k] * b[k][j];
        }
    }
    return result;
}

Rows moved_by(double x, double y, double z) {
    return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}};
}

/// The axes of a camera with this yaw as rows.
Rows turned_by(double yaw) {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
}

/// An object turned about y: z toward x.
Rows object_turned_by(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}};
}

double ndc_z(double z, double near, double far) {
    return far / (far - near) * (1.0 - near / z);
}

Frame room_frame(const Scene& room, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(room);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return prepare_frame(room, settings);
}

Scene read_room() {
    return read_scene(lessons_folder() + "/scenes/lab-room.toml");
}

PREDICTIONS_TEST("Lesson 15: matrices by hand", "15-matrices", "in-the-world", "three-rows",
                 "last-column", "normal-moved", "moved-then-turned", "divided", "same-pixels",
                 "bottom-row") {
    const Questions lesson("15-matrices");
    // The lower left corner at the front of the first wedge of turned-block.toml.
    const Column in_world = times(moved_by(-1.5, 0.3, 0.4), {-0.5, 0.5, -0.5, 1.0});
    for (const double wrong : {-0.5, -1.5, -1.0})
        lesson.require_number("in-the-world", in_world[0], 1e-5, wrong);

    // What leaves the origin where it is can be nine numbers; p - C does not.
    const Rows doubled{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}}};
    const Rows mirrored{{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const Column zero{0, 0, 0, 1};
    CHECK(times(doubled, zero) == zero);
    CHECK(times(mirrored, zero) == zero);
    CHECK(times(moved_by(-0.5, 0.8, 3.0), zero) != zero);
    lesson.require_choice("three-rows", 2);

    const double quarter = std::acos(0.0);
    const Column origin = times(turned_by(-quarter), times(moved_by(-0.5, 0.8, 3.0), zero));
    CHECK(origin[2] == Approx(0.5));
    for (const double wrong : {-0.5, -3.0, 0.5})
        lesson.require_number("last-column", origin[0], 1e-4, wrong);
    CHECK(product(turned_by(-quarter), moved_by(-0.5, 0.8, 3.0))[0][3] == Approx(origin[0]));

    // The back wall's normal with w = 1, moved by a camera at z = -3.001; the lamp hangs in front
    // of the wall, at z = -0.7.
    const Column normal = times(moved_by(0, 0, 3.001), {0, 0, -1, 1});
    const double point_z = 1.0, lamp_z = -0.7;
    CHECK(normal[2] * (lamp_z - point_z) < 0.0);
    lesson.require_choice("normal-moved", 1);

    const Column corner{-0.5, -0.4, -0.25, 1.0};
    const Column walked = times(product(object_turned_by(quarter), moved_by(2, 0, 0)), corner);
    CHECK(walked[0] == Approx(-0.25));
    CHECK(walked[2] == Approx(-1.5));
    lesson.require_choice("moved-then-turned", 2);
    const Column turned = times(product(moved_by(2, 0, 0), object_turned_by(quarter)), corner);
    CHECK(turned[0] == Approx(1.75)); // the other order, which the step shows

    // Row vectors, transposed; the column (x, y, z, 1) leaves x, y and z to the turn alone.
    Rows bottom{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 3.001, 1}}};
    const Column seen = times(product(turned_by(0.0), bottom), {1, 1, 1, 1});
    CHECK(seen[2] == 1.0);
    CHECK(seen[3] == Approx(4.001));
    lesson.require_choice("bottom-row", 2);

    const Scene room = read_room();
    const Frame lab = room_frame(room, {"stage=depth"});
    const Rows chain =
        product(product({{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}}}, turned_by(0.0)),
                moved_by(0, 0, 3.001));
    const Column back_corner = times(chain, {1.0, 1.0, 1.0, 1.0});
    for (const double wrong : {2.0, 0.25, 125.0})
        lesson.require_number("divided", back_corner[0] / back_corner[3], 1e-4, wrong);
    int elsewhere = 0;
    for (int t = 0; t < room.triangle_count(); ++t) {
        for (int v = 0; v < 3; ++v) {
            const glm::dvec3 p(room.corner(t, v).position);
            const Column clip = times(chain, {p.x, p.y, p.z, 1.0});
            const int column = static_cast<int>(250.0 * clip[0] / clip[3]) + 250;
            const int row = static_cast<int>(250.0 * clip[1] / clip[3]) + 250;
            const ScreenVertex& drawn = lab.triangle_vertices(t)[static_cast<std::size_t>(v)];
            elsewhere += drawn.column != column || drawn.row != row ? 1 : 0;
        }
    }
    CHECK(elsewhere == 0);
    CHECK(draw_frame(lab).colour ==
          draw_frame(room_frame(room, {"stage=depth", "transform=matrices"})).colour);
    lesson.require_choice("same-pixels", 0);
    // Only the last digits differ, which a camera that is turned by 0.2 shows in two pixels.
    const auto turned_picture = [&](const std::string& way) {
        return draw_frame(room_frame(room, {"stage=depth", "camera.yaw=0.2", "transform=" + way}))
            .colour;
    };
    const auto by_lines = turned_picture("lab"), by_matrices = turned_picture("matrices");
    int different = 0;
    for (std::size_t i = 0; i < by_lines.size(); ++i)
        different += by_lines[i] != by_matrices[i] ? 1 : 0;
    require_text("15-matrices.md", "2 of 250 000 pixels differ");
    CHECK(different == 2);
}

TEST_CASE("Lesson 15: what its tasks ask for is what its hints say") {
    const Scene room = read_room();
    const auto corner = [&](int triangle, int vertex) {
        return glm::dvec3(room.corner(triangle, vertex).position);
    };
    // Two opposite corners of the red block's top, as the hint has them.
    CHECK(glm::distance(corner(18, 0), glm::dvec3(0.135, 0.405, -0.020)) < 1e-3);
    CHECK(glm::distance(corner(18, 1), glm::dvec3(0.532, 0.405, -0.766)) < 1e-3);
    const glm::dvec3 middle = 0.5 * (corner(18, 0) + corner(18, 1));
    CHECK(glm::distance(glm::dvec3(middle.x, 0.5 * (0.405 + 1.0), middle.z),
                        glm::dvec3(0.33, 0.70, -0.39)) < 0.01);
    // A target along (sin, 0, cos) gives the axes of the yaw.
    const glm::mat3 axes =
        look_at_rotation({0, 0, -3.001f}, {0.30934f, 0, -2.001f}, {0.0f, -1.0f, 0.0f});
    const Rows by_yaw = turned_by(0.3);
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            CHECK(static_cast<double>(axes[i][k]) ==
                  Approx(by_yaw[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)])
                      .margin(1e-4));
        }
    }
}

TEST_CASE("Lesson 15: glm's lookAt, as the lesson has it, becomes the camera's matrix") {
    // Rows right, up and back, for up = (0, -1, 0); the second and third row change sign.
    const glm::dvec3 eye(0.5, -0.8, -3.0), forward(std::sin(0.3), 0.0, std::cos(0.3));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, -1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const std::array<glm::dvec3, 3> rows{right, -up, forward};
    const Rows ours = turned_by(0.3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(rows[i].x == Approx(ours[i][0]).margin(1e-12));
        CHECK(rows[i].y == Approx(ours[i][1]).margin(1e-12));
        CHECK(rows[i].z == Approx(ours[i][2]).margin(1e-12));
        CHECK(-glm::dot(rows[i], eye) ==
              Approx(product(ours, moved_by(-eye.x, -eye.y, -eye.z))[i][3]).margin(1e-12));
    }
}

PREDICTIONS_TEST("Lesson 16: parallel rays and ndc z by hand", "16-orthographic", "back-wall",
                 "affine", "box-depth", "half-range", "halfway") {
    const Questions lesson("16-orthographic");
    const double scale = 500.0 / 3.001;
    CHECK(scale == Approx(166.6).margin(0.05));
    lesson.require_choice("back-wall", 2);

    const Scene room = read_room();
    const auto colours = [&](const std::string& way) {
        return draw_frame(room_frame(room, {"stage=pixel_light", "light.power=14",
                                            "projection=orthographic", "camera.yaw=0.3",
                                            "interpolation=" + way}))
            .colour;
    };
    const auto affine = colours("affine"), perspective = colours("perspective");
    int different = 0;
    for (std::size_t i = 0; i < affine.size(); ++i)
        different += affine[i] != perspective[i] ? 1 : 0;
    CHECK(different == 0);
    lesson.require_choice("affine", 0);

    lesson.require_number("box-depth", (4.001 - 1.0) / (7.0 - 1.0), 1e-4, 4.0 / 7.0);

    double low = 0.1, high = 100.0; // between which half of the range is used up
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (ndc_z(middle, 0.1, 100.0) < 0.5 ? low : high) = middle;
    }
    for (const double wrong : {50.0, 0.1, 0.29, 2.0})
        lesson.require_number("half-range", low, 1e-3, wrong);

    // The camera of mix 0.5 is 1 farther back, with the f that keeps the depth of the origin.
    const double half_way = 500.0 * 4.001 / 3.001 / 5.001;
    CHECK(half_way == Approx(133.3).margin(0.05));
    // The same by w = (1 - mix) z + mix, and a factor that keeps the size at 3.001.
    CHECK(half_way == Approx(scale * (0.5 * 3.001 + 0.5) / (0.5 * 4.001 + 0.5)));
    CHECK(half_way < 0.5 * (500.0 / 4.001 + scale) - 2.0);
    lesson.require_choice("halfway", 0);
}

TEST_CASE("Lesson 16: what it says in figures") {
    CHECK(ndc_z(4.0, 0.1, 100.0) == Approx(0.97598).margin(0.00001));
    CHECK(ndc_z(0.2, 0.1, 100.0) == Approx(0.5005).margin(0.0001));
    const Scene room = read_room();
    const auto colours = [&](const std::string& way) {
        return draw_frame(room_frame(room, {"stage=pixel_light", "light.power=14",
                                            "interpolation=" + way}))
            .colour;
    };
    const auto affine = colours("affine"), perspective = colours("perspective");
    int different = 0;
    for (std::size_t i = 0; i < affine.size(); ++i)
        different += affine[i] != perspective[i] ? 1 : 0;
    CHECK(different == 229956);
    // The picture of mix 0.5 is that of a camera one unit behind.
    const Frame mixed = room_frame(room, {"stage=depth", "projection_mix=0.5"});
    const Frame behind = room_frame(
        room, {"stage=depth", "camera.position=0,0,-4.001", "camera.focal_length=666.6"});
    for (int t = 0; t < room.triangle_count(); ++t) {
        for (int v = 0; v < 3; ++v) {
            const glm::vec2 a = mixed.given_vertex(t, v).pixel.position;
            const glm::vec2 b = behind.given_vertex(t, v).pixel.position;
            CHECK(glm::distance(a, b) < 0.1f);
        }
    }
}

TEST_CASE("Lesson 16: a window on the near plane need not be in the middle") {
    require_text("16-orthographic.md", "It need not be in the middle.");
    const Scene room = read_room();
    // A window from -0.5 to 0.5 at near = 1 shows what f = 500 does; from 0 to 1, all of it is 250
    // pixels farther left, near and far alike.
    const auto by_box = [&](const std::string& box) {
        return room_frame(room, {"stage=depth", "transform=matrices", "near=1", "far=7", box});
    };
    const Frame usual = by_box("view_box=auto");
    for (const auto& [box, moved] : {std::pair("view_box=-0.5,0.5,-0.5,0.5", 0.0f),
                                     std::pair("view_box=0,1,-0.5,0.5", -250.0f)}) {
        const Frame boxed = by_box(box);
        for (int t = 0; t < room.triangle_count(); ++t) {
            for (int v = 0; v < 3; ++v) {
                const glm::vec2 a = usual.given_vertex(t, v).pixel.position;
                const glm::vec2 b = boxed.given_vertex(t, v).pixel.position;
                CHECK(glm::distance(a + glm::vec2(moved, 0.0f), b) < 0.01f);
            }
        }
    }
    // Orthographic, the box from 0 to 1 shows half of the room, which goes from -1 to 1.
    const Frame half = room_frame(room, {"stage=depth", "transform=matrices", "near=1", "far=7",
                                         "view_box=0,1,-0.5,0.5", "projection=orthographic"});
    for (const float x : {-1.0f, 1.0f}) {
        for (int t = 0; t < room.triangle_count(); ++t) {
            for (int v = 0; v < 3; ++v) {
                if (room.corner(t, v).position.x != x) continue;
                CHECK(half.given_vertex(t, v).pixel.position.x == Approx(500.0f * x).margin(0.01));
            }
        }
    }
}

} // namespace spaces_track
} // namespace
