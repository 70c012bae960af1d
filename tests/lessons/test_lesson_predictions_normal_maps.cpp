// The predictions and figures of lesson 29, found a second time: by the formulas from which its
// maps are made, in double, at the places where the rays of pixels meet the boards.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "scene/read_scene.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "support/quoted_text.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace bumps {

constexpr double degrees = 57.29577951308232;
const std::string file = "29-normal-maps.md";

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return degrees * std::acos(glm::dot(glm::normalize(a), glm::normalize(b)));
}

/// -1..1 by way of a byte.
double through_byte(double part) {
    const double byte = std::floor((part + 1.0) / 2.0 * 255.0 + 0.5);
    return 2.0 * byte / 255.0 - 1.0;
}

/// A pixel of scenes/studs.toml, on the left board: all of it is 2 away from the camera.
struct OnBoard {
    glm::dvec3 place;
    glm::dvec3 arrow; ///< right, up, away

    OnBoard(int column, int row) {
        place = {(column + 0.5 - 160.0) / 320.0 * 2.0, (row + 0.5 - 80.0) / 320.0 * 2.0, 2.0};
        const glm::dvec2 uv{(place.x + 0.96) / 0.9 * 2.0, (place.y + 0.45) / 0.9 * 2.0};
        const auto texel = [](double coordinate) {
            return std::fmod(std::floor(coordinate * 32.0), 32.0) + 0.5;
        };
        // The cap of a ball of 16 texels, 12 around the middle.
        const double right = texel(uv.x) - 16.0, up = 16.0 - texel(uv.y);
        const double square = right * right + up * up;
        arrow = square < 144.0
                    ? glm::dvec3(right / 16.0, up / 16.0, std::sqrt(256.0 - square) / 16.0)
                    : glm::dvec3(0.0, 0.0, 1.0);
        for (int i = 0; i < 3; ++i)
            arrow[i] = through_byte(arrow[i]);
    }
    /// n · l for the lamp of the scene.
    double cosine(const glm::dvec3& of) const {
        const glm::dvec3 way = glm::dvec3(-0.4, -1.3, 0.9) - place;
        const glm::dvec3 normal{of.x, -of.y, -of.z};
        return std::max(0.0, glm::dot(glm::normalize(normal), glm::normalize(way)));
    }
};

PREDICTIONS_TEST("Lesson 29: the normal of a roof that is stretched", "29-normal-maps",
                 "twice-as-high") {
    // Two directions in the stretched roof: along it, and up it; the normal is across both.
    const glm::dvec3 along{1, 0, 0}, up{0, -2, 1}, steep = glm::normalize(glm::cross(along, up));
    const glm::dvec3 flat = glm::normalize(glm::cross(along, glm::dvec3(0, -1, 1)));
    CHECK(steep.y == Approx(-0.4472).margin(1e-4));
    CHECK(flat.y == Approx(-0.7071).margin(1e-4));
    CHECK(glm::normalize(glm::dvec3(0, 2.0 * flat.y, flat.z)).y == Approx(-0.894).margin(0.001));
    CHECK(glm::dot(glm::dvec3(0, -2, 1), glm::dvec3(0, -2, -1)) == 3.0);
    CHECK(glm::dot(glm::dvec3(0, -2, 1), glm::dvec3(0, -0.5, -1)) == 0.0);
    for (const char* figure : {"−0.89: stretched", "−0.71: directions stay", "−0.45: it leans",
                               "have a product of 3", "y is −0.71"})
        require_text(file, figure);
    const Questions lesson("29-normal-maps");
    lesson.require_choice("twice-as-high", 2);
}

PREDICTIONS_TEST("Lesson 29: the flat blue of bytes, and colours used as arrows", "29-normal-maps",
                 "flat-blue", "undecoded") {
    const glm::dvec3 out{0, 0, 1};
    const double middle = 2.0 * 128.0 / 255.0 - 1.0;
    CHECK(middle == Approx(0.0039).margin(0.00005));
    require_text(file, "but 0.0039");
    const OnBoard ground(12, 12);
    CHECK(ground.arrow.x == middle);
    CHECK(ground.arrow.y == middle);
    const Questions lesson("29-normal-maps");
    CHECK(degrees_between(ground.arrow, out) == Approx(1.0 / 3.0).margin(0.05));
    lesson.require_choice("flat-blue", 1);
    lesson.require_number("undecoded", degrees_between({128.0 / 255.0, 128.0 / 255.0, 1.0}, out),
                          1e-3, 45.0);
    CHECK(degrees_between({0.5, 0.5, 1.0}, out) == Approx(35.26).margin(0.01));
    const double one_way = degrees_between({0.5, 0.0, 1.0}, out); // if you forget y
    CHECK(one_way == Approx(26.57).margin(0.01));
    CHECK_FALSE(lesson.answered("undecoded", {one_way}).is_right);
}

PREDICTIONS_TEST("Lesson 29: the upper half of a stud, with green up and down", "29-normal-maps",
                 "green-turned") {
    const OnBoard stud(42, 26);
    CHECK(stud.arrow.y > 0.4);
    CHECK(stud.cosine(stud.arrow) == Approx(0.95).margin(0.005));
    CHECK(stud.cosine({0, 0, 1}) == Approx(0.73).margin(0.005));
    require_text(file, "n · l is 0.95");
    require_text(file, "would have 0.73");
    const glm::dvec3 turned{stud.arrow.x, -stud.arrow.y, stud.arrow.z};
    CHECK(stud.cosine(turned) < 0.5);
    const Questions lesson("29-normal-maps");
    lesson.require_choice("green-turned", 2);
    const Judgement said = lesson.answered("green-turned", {2.0});
    CHECK(said.because.find(fmt::format("{:.2f}", stud.cosine(turned))) != std::string::npos);
}

/// A pixel of scenes/brick-heights.toml: the wall is at z = 2, from x = -1 and y = -0.75 on.
struct OnTallWall {
    glm::dvec3 place, view; ///< the direction to the eye along right, up and out
    double height;          ///< of the map made by tests/scene/test_made_textures.cpp

    OnTallWall(const glm::dvec3& eye, double yaw, int column, int row) {
        const double x = (column + 0.5 - 160.0) / 300.0, y = (row + 0.5 - 120.0) / 300.0;
        const glm::dvec3 ray{x * std::cos(yaw) + std::sin(yaw), y,
                             std::cos(yaw) - x * std::sin(yaw)};
        place = eye + (2.0 - eye.z) / ray.z * ray;
        const glm::dvec3 to_eye = glm::normalize(eye - place);
        view = {to_eye.x, -to_eye.y, -to_eye.z};
        const int texel_x = static_cast<int>(std::floor((place.x + 1.0) * 32.0)) % 32,
                  texel_y = static_cast<int>(std::floor((place.y + 0.75) * 32.0)) % 32;
        const int along = (texel_x + texel_y / 8 % 2 * 8) % 16;
        const bool is_mortar = texel_y % 8 == 7 || along == 15;
        height = is_mortar ? -0.06 : 0.0; // if it is not at the rim of a brick
    }
    double sideways() const { return std::hypot(view.x, view.y); }
};

PREDICTIONS_TEST("Lesson 29: how far a height shifts the texture", "29-normal-maps", "mortar-step",
                 "step-ahead") {
    const OnTallWall mortar({-1.35, -0.1, 0.95}, 0.85, 200, 136);
    CHECK(mortar.height == -0.06);
    CHECK(mortar.view.z == Approx(0.55).margin(0.005));
    CHECK(mortar.sideways() == Approx(0.83).margin(0.005));
    CHECK(std::sqrt(1.0 - 0.55 * 0.55) == Approx(0.83).margin(0.01));
    const double divided = 0.06 * mortar.sideways() / mortar.view.z;
    CHECK(divided == Approx(0.09).margin(0.001));
    CHECK(0.06 * mortar.sideways() == Approx(0.05).margin(0.0005));
    CHECK(0.06 * mortar.view.z == Approx(0.033).margin(0.0005));
    CHECK(mortar.view.x < 0.0); // the eye is on the left; minus times minus goes right, away
    for (const char* figure : {"V.z is 0.55", "−0.06 for the mortar", "0.83 / 0.55 is 0.09"})
        require_text(file, figure);
    const Questions lesson("29-normal-maps");
    lesson.require_number("mortar-step", divided, 1e-4, 0.06);
    const OnTallWall ahead({0.0, 0.0, 0.9}, 0.0, 160, 118);
    CHECK(ahead.height == -0.06);
    CHECK(0.06 * ahead.sideways() < 0.003);
    lesson.require_choice("step-ahead", 2);
}

TEST_CASE("Lesson 29: the map of the bricks bends by 37 degrees, and only where a brick ends") {
    // White is 1.5 texels above black, and a slope is taken over two texels: 0.75 to 1.
    const Scene wall = read_scene(lessons_folder() + "/scenes/brick-relief.toml");
    const TextureLevel& map = normal_map_of(wall, 0)->base();
    for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < map.width; ++column) {
            const glm::dvec3 arrow = 2.0 * glm::dvec3(map.at(column, row)) - 1.0;
            const double tilt = degrees_between(arrow, {0, 0, 1});
            const int along = (column + row / 8 % 2 * 8) % 16;
            const bool is_mortar = row % 8 == 7 || along == 15;
            const bool ends_above = row % 8 == 0, ends_below = row % 8 == 6;
            const bool ends_aside = along == 0 || along == 14;
            INFO(column << "," << row);
            if (is_mortar || !(ends_above || ends_below || ends_aside)) continue;
            CHECK(tilt == Approx(ends_aside && (ends_above || ends_below)
                                     ? degrees * std::atan(0.75 * std::sqrt(2.0))
                                     : degrees * std::atan(0.75))
                              .margin(0.4));
        }
    }
    CHECK(degrees_between(2.0 * glm::dvec3(map.at(7, 3)) - 1.0, {0, 0, 1}) < 0.4);
}

} // namespace bumps
} // namespace
