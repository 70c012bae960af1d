// The look back of lessons 2 and 4 to 19, and of lesson 28, each answered a second time: by
// arithmetic from the scenes' numbers, by definitions, or by trying out every case there is.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "support/questions.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr double room_f = 500.0;
constexpr double depth_of_wall = 4.001, depth_of_opening = 2.001;
constexpr double sphere_of_one = 12.566370614359172; ///< area of a sphere with the radius 1

/// v turned by a yaw about the y axis.
glm::dvec3 turned_by_yaw(const glm::dvec3& v, double yaw) {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

/// Of the three crossings of needles in a ring, how many does this order of drawing get wrong?
/// Needle i is in front of needle (i + 1) % 3.
int wrong_crossings(const std::array<int, 3>& order) {
    int wrong = 0;
    for (int i = 0; i < 3; ++i) {
        const auto front = std::find(order.begin(), order.end(), i);
        const auto back = std::find(order.begin(), order.end(), (i + 1) % 3);
        if (front < back) ++wrong;
    }
    return wrong;
}
int fewest_wrong_crossings() {
    std::array<int, 3> order{0, 1, 2};
    int fewest = 3;
    do
        fewest = std::min(fewest, wrong_crossings(order));
    while (std::next_permutation(order.begin(), order.end()));
    return fewest;
}

/// The direct light of a lamp with the power 14 at distance r, with this cosine.
double lamp_light_at(double r, double cosine) {
    return 14.0 * cosine / (sphere_of_one * r * r);
}

} // namespace

PREDICTIONS_TEST("Look back on lesson 1: the focal length", "04-edges", "look-back-1") {
    const double before = room_f / depth_of_wall;
    const double after = 2.0 * room_f / depth_of_wall;
    require_look_back("04-edges", {after == 2.0 * before, after > before && after < 1.9 * before,
                                   after == before});
}

PREDICTIONS_TEST("Look back on lesson 2: the order of the two operations", "06-filling",
                 "look-back-2") {
    const glm::dvec3 v(1.0, -1.0, 1.0), c(0.5, 0.0, -3.001);
    const auto wrong = [&](double yaw) { return turned_by_yaw(v, yaw) - c; };
    const auto right = [&](double yaw) { return turned_by_yaw(v - c, yaw); };
    REQUIRE(glm::length(wrong(0.3) - right(0.3)) > 0.1);
    require_look_back("06-filling", {wrong(0.0) == right(0.0),
                                     wrong(0.0) != right(0.0) && wrong(0.0).z == right(0.0).z,
                                     wrong(0.0).z != right(0.0).z});
}

PREDICTIONS_TEST("Look back on lesson 3: int() near the middle", "02-moving-the-camera",
                 "look-back-3") {
    const double x = room_f * (1.0 - 1.0056) / depth_of_wall;
    REQUIRE(x == Approx(-0.7).margin(0.001));
    const int column = static_cast<int>(x) + 250;
    require_look_back("02-moving-the-camera", {column == 249, column == 250, column == 251});
}

PREDICTIONS_TEST("Look back on lesson 4: how many samples", "05-row-table", "look-back-4") {
    // Neighbours are at most one pixel apart on either axis.
    int samples = 2;
    while (10.0 / (samples - 1) > 1.0 || 3.0 / (samples - 1) > 1.0)
        ++samples;
    const Questions asked("05-row-table");
    asked.require_number("look-back-4", samples, 0.0, 10.0);
    asked.require_number("look-back-4", samples, 0.0, 4.0);
}

PREDICTIONS_TEST("Look back on lesson 5: how the left end of a row begins", "07-painters-order",
                 "look-back") {
    // Row 12, edge by edge: ten steps each, in halves and tenths that a float holds, or nearly.
    std::vector<int> columns;
    const std::array<glm::dvec2, 3> corners{{{15, 15}, {5, 10}, {10, 5}}};
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const glm::dvec2 from = corners[edge], to = corners[(edge + 1) % 3];
        const int steps =
            static_cast<int>(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)));
        for (int i = 0; i <= steps; ++i) {
            const glm::dvec2 p = from + (to - from) * (static_cast<double>(i) / steps);
            if (static_cast<int>(p.y + 1e-9) == 12) columns.push_back(static_cast<int>(p.x + 1e-9));
        }
    }
    REQUIRE(columns == std::vector<int>{10, 9, 13});
    const auto left_end = [&](int start) {
        for (const int column : columns)
            if (column < start) start = column;
        return start;
    };
    const int smallest = *std::min_element(columns.begin(), columns.end());
    require_look_back("07-painters-order", {left_end(2147483647) == smallest,
                                            left_end(0) == smallest, left_end(-1) == smallest});
}

PREDICTIONS_TEST("Look back on lesson 6: who draws a shared edge", "08-depth-buffer", "look-back") {
    // In row 150 one triangle ends where the other begins, at the diagonal from (126, 126).
    const int x = 150, left_end = 126, right_end = 374, diagonal = 126 + (150 - 126);
    const bool is_in_lower = x >= left_end && x <= diagonal;
    const bool is_in_upper = x >= diagonal && x <= right_end;
    require_look_back("08-depth-buffer", {is_in_lower && is_in_upper, is_in_lower && !is_in_upper,
                                          !is_in_lower && is_in_upper});
}

PREDICTIONS_TEST("Look back on lesson 7: needles in a ring", "09-light-per-vertex", "look-back") {
    const int fewest = fewest_wrong_crossings();
    require_look_back("09-light-per-vertex", {fewest == 0, fewest == 1, fewest == 2});
}

PREDICTIONS_TEST("Look back on lesson 8: halfway on the screen", "10-light-per-pixel",
                 "look-back") {
    const double z = 2.0 / (1.0 / 1.0 + 1.0 / 3.0);
    require_look_back("10-light-per-pixel", {z < 1.95, z >= 1.95 && z <= 2.05, z > 2.05});
}

PREDICTIONS_TEST("Look back on lesson 9: twice as far from the lamp", "11-perspective",
                 "look-back") {
    const double share = lamp_light_at(1.0, 1.0) / lamp_light_at(0.5, 1.0);
    require_look_back("11-perspective",
                      {std::abs(share - 0.25) < 1e-6, std::abs(share - 0.5) < 1e-6,
                       std::abs(share - 0.125) < 1e-6});
}

PREDICTIONS_TEST("Look back on lesson 10: what is interpolated", "12-float-traps", "look-back") {
    // The lamp is half a unit below the ceiling, at (0, -0.5, -0.7).
    double nearest_corner = 100.0, brightest_corner = 0.0;
    for (const double x : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
            const double r = glm::length(glm::dvec3(x, -0.5, z + 0.7));
            nearest_corner = std::min(nearest_corner, r);
            brightest_corner = std::max(brightest_corner, lamp_light_at(r, 0.5 / r));
        }
    }
    // A blend of the corners gives neither so much light nor so short a distance.
    const double wanted_light = 3.3, wanted_distance = 0.6;
    require_look_back("12-float-traps",
                      {lamp_light_at(0.5, 1.0) > wanted_light, brightest_corner > wanted_light,
                       nearest_corner < wanted_distance});
}

PREDICTIONS_TEST("Look back on lesson 11: what changes in equal steps", "13-reading-a-bug",
                 "look-back") {
    // Along the left wall q goes from -1 to 1, and the depth is q + 3.001; x on the screen is
    // proportional to 1 / depth, so halfway on the screen 1 / depth is the mean of the ends.
    const double depth = 2.0 / (1.0 / depth_of_opening + 1.0 / depth_of_wall);
    const double q = depth - 3.001;
    const auto is_mean = [](double middle, double a, double b) {
        return std::abs(middle - 0.5 * (a + b)) < 1e-6;
    };
    require_look_back("13-reading-a-bug",
                      {is_mean(q, -1.0, 1.0),
                       is_mean(q / depth, -1.0 / depth_of_opening, 1.0 / depth_of_wall),
                       is_mean(q * depth, -depth_of_opening, depth_of_wall)});
}

PREDICTIONS_TEST("Look back on lesson 12: floor in place of int", "14-arrows", "look-back") {
    const double row = 0.999842;
    const bool helps_all = static_cast<int>(std::floor(row)) == 1;
    const bool helps_some = std::floor(row) != static_cast<int>(row);
    require_look_back("14-arrows", {!helps_all && !helps_some, helps_all, helps_some});
}

PREDICTIONS_TEST("Look back on lesson 13: drawn on and still black", "15-matrices", "look-back") {
    // The back wall's 1/z, against a buffer that begins with 0.35.
    const double half = room_f / depth_of_wall;
    const bool has_fallen = std::abs(180.0 - 250.0)<half, passes = 1.0 / depth_of_wall> 0.35;
    require_look_back("15-matrices", {!has_fallen, has_fallen && !passes, has_fallen && passes});
}

PREDICTIONS_TEST("Look back on lesson 14: an angle of more than 90 degrees", "16-orthographic",
                 "look-back") {
    const glm::dvec2 u(6.0, 0.0), v(-6.0, -8.0);
    const double angle = std::abs(std::atan2(v.y, v.x) - std::atan2(u.y, u.x));
    REQUIRE(angle > sphere_of_one / 8.0);
    const double product = glm::length(u) * glm::length(v) * std::cos(angle);
    require_look_back("16-orthographic", {product > 0.0, product == 0.0, product < 0.0});
}

PREDICTIONS_TEST("Look back on lesson 15: what a perspective matrix puts into w", "17-near-plane",
                 "look-back") {
    const glm::dvec4 last_row(0.0, 0.0, 1.0, 0.0), corner(1.0, 1.0, depth_of_wall, 1.0);
    const double w = glm::dot(last_row, corner);
    require_look_back("17-near-plane", {w == depth_of_wall, w == 1.0, w == 0.0});
}

PREDICTIONS_TEST("Look back on lesson 16: without the division", "18-outcodes", "look-back") {
    const double by_depth_of_origin = room_f / 3.001;
    const double opening = by_depth_of_origin * 1.0, wall = by_depth_of_origin * 1.0;
    require_look_back("18-outcodes", {wall<0.51 * opening, wall> 0.51 * opening && wall < opening,
                                      wall == opening});
}

PREDICTIONS_TEST("Look back on lesson 17: a vertex behind you", "19-culling", "look-back") {
    const double x = 160.0 * 1.0 / -2.0;
    require_look_back("19-culling", {x<0.0, x> 0.0, !std::isfinite(x)});
}

PREDICTIONS_TEST("Look back on lesson 26: what a BSP tree does", "28-shine", "look-back") {
    // The points of scenes/three-needles.toml. In whatever order the tree takes their planes, the
    // first one cuts another needle.
    const std::array<std::array<glm::dvec3, 3>, 3> needles{{
        {{{-0.3106, -0.6873, 2}, {0.0356, -0.8877, 2}, {1.43, 1.37, 4}}},
        {{{0.825, 0.2, 2}, {0.825, 0.6, 2}, {-1.76, 0.8, 4}}},
        {{{-0.5144, 0.7377, 2}, {-0.8606, 0.5373, 2}, {0.33, -1.67, 4}}},
    }};
    int planes_that_cut = 0;
    for (const auto& a : needles) {
        const glm::dvec3 normal = glm::cross(a[1] - a[0], a[2] - a[0]);
        planes_that_cut += std::any_of(needles.begin(), needles.end(), [&](const auto& b) {
            const auto side = [&](const glm::dvec3& p) { return glm::dot(normal, p - a[0]); };
            const double low = std::min({side(b[0]), side(b[1]), side(b[2])});
            const double high = std::max({side(b[0]), side(b[1]), side(b[2])});
            return low < -1e-6 && high > 1e-6;
        });
    }
    REQUIRE(fewest_wrong_crossings() > 0);
    // It needs neither squares nor depths at pixels: see the definitions of Warnock and Catmull.
    require_look_back("28-shine", {planes_that_cut == 3, false, planes_that_cut == 0});
}
