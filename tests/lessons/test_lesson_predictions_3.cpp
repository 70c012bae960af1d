// The predictions of lessons 14, 17, 18 and 19: each answer that the program computes from its
// facts is found here a second time, in double, from the handout's numbers and the places in the
// scenes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/oracle.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace geometry_track {

using Corner = glm::dvec3;
using Corners3 = std::array<Corner, 3>;

/// The handout's room, in the order of drawing: corners on the floor, then those above them.
std::vector<Corners3> room_triangles() {
    using Foot = std::array<glm::ivec2, 4>;
    std::vector<Corners3> triangles;
    const auto add = [&](const Foot& foot, int height, const std::string& letters) {
        for (std::size_t i = 0; i + 2 < letters.size(); i += 3) {
            Corners3& corners = triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const int n = letters[i + k] - 'A';
                const glm::ivec2 at = foot[static_cast<std::size_t>(n % 4)];
                corners[k] = {1.0 - 2.0 * at.x / 555.0, 1.0 - 2.0 * (n < 4 ? 0 : height) / 555.0,
                              2.0 * at.y / 555.0 - 1.0};
            }
        }
    };
    const std::string block = "EBAEFBFDBFHDHCDHGCGECEACGFEGHF";
    add({{{555, 0}, {0, 0}, {555, 555}, {0, 555}}}, 555, "CBACDBAECCEGFBDHFDEFGFHGGDCGHD");
    add({{{290, 114}, {130, 65}, {240, 272}, {82, 225}}}, 165, block);
    add({{{423, 247}, {265, 296}, {472, 406}, {314, 456}}}, 330, block);
    return triangles;
}

/// The lab's normal, not of unit length.
Corner upright(const Corners3& t) {
    return glm::cross(t[2] - t[0], t[1] - t[0]);
}

bool shows_back(const Corners3& t, const Corner& camera) {
    return glm::dot(upright(t), t[0] - camera) > 0.0;
}

/// The part of the polygon at z >= near, seen from a camera that looks along z.
std::vector<Corner> cut_near(const std::vector<Corner>& polygon, double near) {
    std::vector<Corner> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (a.z >= near) left.push_back(a);
        if ((a.z >= near) != (b.z >= near))
            left.push_back(glm::mix(a, b, (near - a.z) / (b.z - a.z)));
    }
    return left;
}

/// A camera at (0, 0, z) that looks along z, and a square picture.
struct Standpoint {
    double z = -3.001;
    double focal_length = 500.0;
    double near = 0.0; ///< 0: nothing is cut
};
constexpr int side = 500;

/// The corners of a triangle as pixels.
std::vector<ScreenVertex> pixels_of(const Corners3& triangle, const Standpoint& view) {
    std::vector<Corner> polygon;
    for (const Corner& corner : triangle)
        polygon.push_back(corner - Corner(0.0, 0.0, view.z));
    if (view.near > 0.0) polygon = cut_near(polygon, view.near);
    std::vector<ScreenVertex> pixels;
    for (const Corner& corner : polygon) {
        const auto snapped = [&](double x) {
            return static_cast<int>(view.focal_length * x / corner.z) + side / 2;
        };
        pixels.push_back({{}, snapped(corner.x), snapped(corner.y), 0.0f, 0.0f, 0.0f, {}});
    }
    return pixels;
}

/// Row tables by their definition, of edges that are walked without error: the float walk strays
/// from them by a pixel here and there.
std::map<int, test::RowEnds> rows_of(const Corners3& triangle, const Standpoint& view) {
    const std::vector<ScreenVertex> corners = pixels_of(triangle, view);
    int outside = 0;
    if (corners.empty()) return {};
    return row_table(corners, {{LineWalk::exact, Rounding::truncate}, EdgeSamples::longest_axis},
                     outside);
}

struct Fragments {
    std::int64_t inside = 0, outside = 0;
    double total() const { return static_cast<double>(inside + outside); }
};

template <class Wanted>
Fragments count_fragments(const Standpoint& view, Wanted is_wanted) {
    Fragments count;
    for (const Corners3& triangle : room_triangles()) {
        if (!is_wanted(triangle)) continue;
        for (const auto& [row, ends] : rows_of(triangle, view)) {
            if (ends.left > ends.right) continue;
            const int seen =
                row >= 0 && row < side
                    ? std::max(std::min(ends.right, side - 1) - std::max(ends.left, 0) + 1, 0)
                    : 0;
            count.inside += seen;
            count.outside += ends.right - ends.left + 1 - seen;
        }
    }
    return count;
}

Fragments count_fragments(const Standpoint& view) {
    return count_fragments(view, [](const Corners3&) { return true; });
}

/// Fragments nearer than all that were drawn on their pixel before; 1/z by the triangle's plane.
template <class Wanted>
std::int64_t count_lit(const Standpoint& view, Wanted is_wanted) {
    std::vector<double> nearest(static_cast<std::size_t>(side * side), 0.0);
    std::int64_t lit = 0;
    for (const Corners3& triangle : room_triangles()) {
        if (!is_wanted(triangle)) continue;
        const Corner normal = upright(triangle);
        const double distance = glm::dot(normal, triangle[0] - Corner(0.0, 0.0, view.z));
        for (const auto& [row, ends] : rows_of(triangle, view)) {
            if (row < 0 || row >= side) continue;
            for (int column = std::max(ends.left, 0); column <= std::min(ends.right, side - 1);
                 ++column) {
                const Corner ray((column - side / 2) / view.focal_length,
                                 (row - side / 2) / view.focal_length, 1.0);
                const double zinv = glm::dot(normal, ray) / distance;
                double& stored = nearest[static_cast<std::size_t>(row * side + column)];
                if (zinv <= stored) continue;
                stored = zinv;
                ++lit;
            }
        }
    }
    return lit;
}

const Corner lab_camera(0.0, 0.0, -3.001);

bool is_front(const Corners3& triangle) {
    return !shows_back(triangle, lab_camera);
}

int count_backs(const Corner& camera) {
    int backs = 0;
    for (const Corners3& triangle : room_triangles())
        backs += shows_back(triangle, camera) ? 1 : 0;
    return backs;
}

double dot2(glm::dvec2 u, glm::dvec2 v) {
    return u.x * v.x + u.y * v.y;
}

/// The bits of a place at depth 2 in a picture of 200 x 160 with f = 160.
int code_of(double x, double y) {
    return (x < -1.25 ? 4 : 0) + (x > 1.25 ? 8 : 0) + (y < -1.0 ? 16 : 0) + (y > 1.0 ? 32 : 0);
}

PREDICTIONS_TEST("Lesson 14: dot, cross and the side of a plane by hand", "14-arrows",
                 "moved-along", "shadow", "perpendicular", "behind", "area", "red-side",
                 "swapped") {
    const Questions lesson("14-arrows");
    // All three corners move by (-3, -2): the differences stay.
    const glm::dvec2 start(6, 14), tip_u(16, 14), tip_v(10, 6), move(-3, -2);
    CHECK((tip_u + move) - (start + move) == tip_u - start);
    CHECK((tip_v + move) - (start + move) == tip_v - start);
    lesson.require_choice("moved-along", 1);
    // The foot of the perpendicular from the tip of v is straight below it, in the row of u.
    const double shadow = tip_v.x - start.x, length = tip_u.x - start.x;
    lesson.require_number("shadow", shadow * length, 1e-9, 80.0);
    CHECK(dot2(tip_u - start, tip_v - start) == shadow * length);
    // u was (10, 0), and is twice as long.
    CHECK(dot2({23 - 3, 14 - 14}, {10, 0}) == 2.0 * dot2({10, 0}, {10, 0}));
    CHECK(dot2({23 - 3, 14 - 14}, {3 - 3, 6 - 14}) == 0.0);
    lesson.require_choice("perpendicular", 0);
    lesson.require_number("behind", dot2({20 - 14, 14 - 14}, {8 - 14, 6 - 14}), 1e-9, 36.0);
    // Half the sum over the corners, and not a product of two arrows.
    const double twice = 10 * 10 - 5 * 5 + 5 * 15 - 15 * 10 + 15 * 5 - 10 * 15;
    lesson.require_number("area", std::abs(twice) / 2.0, 1e-9, 75.0);
    lesson.require_number("area", std::abs(twice) / 2.0, 1e-9, 46.0);
    // Pick's theorem: pixels with their centres in a triangle or on its outline.
    const int on_outline = std::gcd(5, 5) + std::gcd(10, 5) + std::gcd(5, 10);
    CHECK(on_outline == 15);
    CHECK(std::abs(twice) / 2.0 + on_outline / 2.0 + 1.0 == 46.0);
    const double away = glm::dot(glm::normalize(upright(room_triangles()[12])),
                                 room_triangles()[12][0] - lab_camera);
    CHECK(away == Approx(-0.133).margin(0.001));
    lesson.require_choice("red-side", away < 0.0 ? 0 : 1);
    CHECK(shows_back(room_triangles()[12], {-0.15, 0.0, -3.001}));
    // A ceiling that faces away from the lamp has only the indirect light.
    const glm::dvec3 lamp(0.0, -0.5, -0.7);
    const double depth = 500.0 / (250.0 - 40.0); // where the ray of pixel (360, 40) is at y = -1
    const glm::dvec3 to_lamp =
        lamp - (lab_camera + depth * glm::dvec3((360.0 - 250.0) / 500.0, -1.0 / depth, 1.0));
    const double squared = glm::dot(to_lamp, to_lamp);
    const double direct = 14.0 * to_lamp.y / std::sqrt(squared) / (4.0 * 3.14159265 * squared);
    CHECK(direct == Approx(1.45).margin(0.02));
    lesson.require_number("swapped", 0.75 * 0.5, 0.001, 0.75 * (0.5 - direct));
}

TEST_CASE("Lesson 14: what its tasks ask for") {
    const std::vector<Corners3> room = room_triangles();
    // The product with a normal of unit length is the distance from the plane.
    const auto distance = [&](std::size_t triangle) {
        return glm::dot(glm::normalize(upright(room[triangle])), room[triangle][0] - lab_camera);
    };
    std::set<std::size_t> backs, near_backs;
    for (std::size_t triangle = 10; triangle < 20; ++triangle) {
        if (distance(triangle) > 0.0) backs.insert(triangle);
        if (distance(triangle) > 0.0 && distance(triangle) < 2.0) near_backs.insert(triangle);
    }
    CHECK(backs == std::set<std::size_t>{14, 15, 16, 17});
    CHECK(near_backs == std::set<std::size_t>{16, 17});
    CHECK(distance(14) == Approx(2.90).margin(0.005));
    // The top of the blue block.
    CHECK(room[28][0].y == Approx(-0.189).margin(0.0005));
    CHECK(shows_back(room[28], {0.0, -0.18, -3.001}));
    CHECK_FALSE(shows_back(room[28], {0.0, -0.26, -3.001}));
}

TEST_CASE("For every triangle of the room the sign of its area says which side it shows") {
    for (const Corners3& triangle : room_triangles()) {
        const std::vector<ScreenVertex> v = pixels_of(triangle, {});
        const glm::dvec2 u(v[1].column - v[0].column, v[1].row - v[0].row);
        const glm::dvec2 w(v[2].column - v[0].column, v[2].row - v[0].row);
        CHECK((u.x * w.y - u.y * w.x < 0.0) == shows_back(triangle, lab_camera));
    }
}

TEST_CASE("A room inside out under light from the lamp is the room") {
    const auto picture = [](const char* name, const char* assignment) {
        const Scene scene = read_scene(lessons_folder() + "/scenes/" + name + ".toml");
        Settings settings = default_settings(scene);
        set_from_text(settings, assignment);
        return draw_frame(prepare_frame(scene, settings));
    };
    const Framebuffer room = picture("lab-room", "light.direction=to_light");
    const Framebuffer both = picture("inside-out", "light.direction=from_light");
    // Edges are walked in the opposite direction, so some pixels change hands.
    std::size_t kept = 0, apart = 0;
    for (std::size_t i = 0; i < room.colour.size(); ++i) {
        if (room.owner[i] != both.owner[i]) continue;
        ++kept;
        apart += glm::distance(room.colour[i], both.colour[i]) > 1.0f / 255.0f ? 1 : 0;
    }
    CHECK(kept > room.colour.size() * 99 / 100);
    CHECK(apart == 0);
}

PREDICTIONS_TEST("Lesson 17: cuts at the near plane by hand", "17-near-plane", "mirrored",
                 "uncovered-after", "cut-t", "clipped-count", "screen-t", "near-too-small") {
    const Questions lesson("17-near-plane");
    const double x = 160.0 * -1.0 / -2.0, y = 160.0 * 1.0 / -2.0;
    lesson.require_choice("mirrored", x > 0.0 && y < 0.0 ? 1 : 0);

    // Inside the room each ray leaves through the nearest of the walls ahead.
    int lost = 0;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double across = std::max(std::abs(column - 250), std::abs(row - 250)) / 250.0;
            const double to_side = across > 0.0 ? 1.0 / across : 1e9, to_back = 1.0 + 0.9;
            lost += std::min(to_side, to_back) < 0.1 ? 1 : 0;
        }
    }
    CHECK(lost == 0);
    lesson.require_choice("uncovered-after", 0);

    lesson.require_number("cut-t", 1.0 - (0.1 + 2.0) / (3.0 + 2.0), 1e-6, 0.42);
    lesson.require_number("cut-t", 1.0 - (0.1 + 2.0) / (3.0 + 2.0), 1e-6, 0.6);
    // The task: edge 0 from z = 1 to z = 4, a camera at 1.65 and the plane 0.1 in front of it.
    const std::vector<Corner> cut =
        cut_near({{-0.8, 0.7, 1.0 - 1.65}, {0.0, 0.7, 4.0 - 1.65}, {0.9, 0.7, 2.0 - 1.65}}, 0.1);
    REQUIRE(cut.size() == 4);
    CHECK(cut[0].x == Approx(0.75 * -0.8)); // of the way from x = 0 to x = -0.8

    int pieces = 0, reach_behind = 0;
    for (const Corners3& triangle : room_triangles()) {
        const auto behind = std::count_if(triangle.begin(), triangle.end(),
                                          [](const Corner& c) { return c.z + 0.9 < 0.1; });
        constexpr std::array<int, 4> left{1, 2, 1, 0};
        pieces += left[static_cast<std::size_t>(behind)];
        reach_behind += behind > 0 ? 1 : 0;
    }
    lesson.require_number("clipped-count", pieces, 1e-9, 30.0);
    lesson.require_number("clipped-count", pieces, 1e-9, 12.0); // only the pieces that were cut
    CHECK(250.0 * 1.0 / 0.01 > 16384.0); // where the corners of the cuts land
    lesson.require_number("near-too-small", reach_behind, 1e-9, 0.0);

    // The upper edge of the wall, x = 1 and z from 0.4 to 8, crosses the border at z = 1.6.
    const double at_border = 160.0 / 100.0;
    const double true_share = (at_border - 0.4) / (8.0 - 0.4);
    const double screen_share = (160.0 / 0.4 - 100.0) / (160.0 / 0.4 - 160.0 / 8.0);
    const auto light = [](double z) {
        const Corner way = Corner(0.0, 0.0, 0.8) - Corner(1.0, -0.5, z);
        const double r = glm::length(way);
        return 0.9 * (14.0 * (1.0 / r) / (4.0 * 3.14159265 * r * r) + 0.1);
    };
    const double error = (light(8.0) - light(0.4)) * (screen_share - true_share);
    int wrong_columns = 0;
    for (int column = 21; column < 100; ++column) {
        const double z = 160.0 / column;
        wrong_columns += std::abs(error * (8.0 - z) / (8.0 - at_border)) > 0.02 ? 1 : 0;
    }
    CHECK(wrong_columns > 60);
    lesson.require_choice("screen-t", 2);
}

PREDICTIONS_TEST("Lesson 18: fragments counted by row tables, and codes by hand", "18-outcodes",
                 "share-outside", "all-fragments", "code", "needle", "and-rejects", "guard-band") {
    const Questions lesson("18-outcodes");
    const Fragments far = count_fragments({.z = -1.5});
    CHECK(static_cast<double>(far.outside) / far.total() == Approx(0.902).margin(0.001));
    lesson.require_choice("share-outside", 2);
    const Fragments middle = count_fragments({.z = -1.2});
    CHECK(100.0 * static_cast<double>(middle.outside) / middle.total() ==
          Approx(98.2).margin(0.05));
    const Fragments near = count_fragments({.z = -1.05});
    lesson.require_number("all-fragments", near.total() / 1e6, 0.5, 100.0);
    const auto of_triangle = [](std::size_t number) {
        const Corners3 wanted = room_triangles()[number];
        return count_fragments({.z = -1.05}, [&](const Corners3& t) { return t == wanted; })
            .total();
    };
    CHECK(of_triangle(6) == Approx(100e6).margin(5e6));
    CHECK(of_triangle(7) < 5e6);
    // The near plane lies nearer than any side of the band: 500 / 0.1 is less than 8192.
    const Fragments cut = count_fragments({.z = -1.05, .near = 0.1});
    lesson.require_number("guard-band", static_cast<double>(cut.outside) / 1e6, 0.5, 0.0);

    lesson.require_number("code", code_of(1.9, -1.6), 1e-9, 40.0);
    const int start = code_of(-1.7, -1.4), end = code_of(1.7, 1.35), other = code_of(1.6, 1.4);
    CHECK((start & end & other) == 0);
    CHECK((start | end | other) == 60);
    lesson.require_choice("needle", 2);
    const int pink = code_of(1.5, 0.1) & code_of(2.2, 0.2) & code_of(1.6, 0.8);
    const int orange = code_of(0.9, -1.6) & code_of(1.9, -1.6) & code_of(1.9, -0.6);
    CHECK(0.9 + 1.6 > 1.25 + 1.0); // its long side passes by the corner of the picture
    lesson.require_number("and-rejects", (pink != 0 ? 1 : 0) + (orange != 0 ? 1 : 0), 1e-9, 2.0);
}

PREDICTIONS_TEST("Lesson 19: backs and what they cost", "19-culling", "backs", "fragments-left",
                 "lit-left", "turned", "mirrored", "inside-out", "by-fragment", "same-picture") {
    const Questions lesson("19-culling");
    const int backs = count_backs(lab_camera);
    lesson.require_number("backs", backs, 1e-9, 15.0);
    const double all = count_fragments({}).total();
    CHECK(all == Approx(328789.0).margin(600.0));
    CHECK(count_fragments({}, is_front).total() == Approx(294473.0).margin(600.0));
    lesson.require_choice("fragments-left", 2);
    lesson.require_choice("by-fragment", 0);
    const auto lit = static_cast<double>(count_lit({}, is_front));
    const auto lit_before =
        static_cast<double>(count_lit({}, [](const Corners3&) { return true; }));
    CHECK(lit_before == Approx(293357.0).margin(1500.0));
    CHECK(lit_before - lit == Approx(293357.0 - 289497.0).margin(900.0));
    CHECK(lit > 0.98 * lit_before);
    lesson.require_choice("lit-left", 2);
    lesson.require_choice("turned", 1); // shows_back() never asks where the camera looks
    // Half a turn of the picture changes neither sign of the two arrows' product.
    lesson.require_number("mirrored", backs, 1e-9, 20.0);
    lesson.require_number("inside-out", 30.0 - backs, 1e-9, 30.0);

    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    set_from_text(settings, "stage=depth");
    const Framebuffer with = draw_frame(prepare_frame(room, settings));
    settings.cull = Cull::face_normal;
    const Framebuffer without = draw_frame(prepare_frame(room, settings));
    int others = 0;
    for (std::size_t i = 0; i < with.owner.size(); ++i) {
        if (with.owner[i] == without.owner[i]) continue;
        // Only where a back had been seen.
        CHECK(shows_back(room_triangles()[static_cast<std::size_t>(with.owner[i])], lab_camera));
        others += with.colour[i] != without.colour[i] ? 1 : 0;
    }
    CHECK(others == 3);
    lesson.require_choice("same-picture", 1);
}

TEST_CASE("Lesson 19: the only fronts that the view axis would lose are those of the left wall") {
    const glm::dvec3 forward(std::sin(0.15), 0.0, std::cos(0.15));
    const std::vector<Corners3> room = room_triangles();
    std::set<std::size_t> lost;
    for (std::size_t triangle = 0; triangle < room.size(); ++triangle) {
        if (glm::dot(upright(room[triangle]), forward) > 1e-9 && is_front(room[triangle]))
            lost.insert(triangle);
    }
    CHECK(lost == std::set<std::size_t>{2, 3});
}

TEST_CASE("Lesson 18: the codes accept one triangle of the blue block") {
    // Seen from (0, 0, -1.5) by a camera that is turned by 0.2; a square picture with f = 500.
    std::set<std::size_t> accepted;
    const std::vector<Corners3> room = room_triangles();
    for (std::size_t triangle = 20; triangle < room.size(); ++triangle) {
        const bool is_inside =
            std::all_of(room[triangle].begin(), room[triangle].end(), [](const Corner& p) {
                const double z = std::sin(0.2) * p.x + std::cos(0.2) * (p.z + 1.5);
                const double x = std::cos(0.2) * p.x - std::sin(0.2) * (p.z + 1.5);
                return z > 0.1 && 500.0 * std::abs(x) < 252.0 * z &&
                       500.0 * std::abs(p.y) < 252.0 * z;
            });
        if (is_inside) accepted.insert(triangle);
    }
    CHECK(accepted == std::set<std::size_t>{23});
}

} // namespace geometry_track
} // namespace
