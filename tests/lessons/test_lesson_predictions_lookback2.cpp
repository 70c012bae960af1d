// The look back of lessons 20 to 36 without 28, each answered a second time: by arithmetic from the
// scenes' numbers, by definitions, or by trying out every case there is.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "settings/setting_table.h"
#include "support/questions.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Do two neighbours claim the centre on the edge that one of them walks by (dx, dy)?
bool takes_its_edge(int dx, int dy) {
    return dy < 0 || (dy == 0 && dx > 0);
}

/// Bresenham's line from the origin to (l, s), 0 <= s <= l: where it ends.
std::pair<int, int> end_by_integers(int l, int s) {
    int y = 0, d = 2 * s - l;
    for (int x = 0; x < l; ++x) {
        if (d >= 0) {
            ++y;
            d -= 2 * l;
        }
        d += 2 * s;
    }
    return {l, y};
}

/// Twice the area of a triangle.
double doubled_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The sides of a picture from -1.25 to 1.25 and from -1 to 1 that a point lies beyond.
std::set<int> sides_it_is_beyond(glm::dvec2 p) {
    std::set<int> sides;
    if (p.x < -1.25) sides.insert(0);
    if (p.x > 1.25) sides.insert(1);
    if (p.y < -1.0) sides.insert(2);
    if (p.y > 1.0) sides.insert(3);
    return sides;
}

/// Which pixels of the drum show something.
std::vector<bool> covered_by_drum(const std::string& shading) {
    const Scene scene = read_scene(lessons_folder() + "/scenes/cylinder.toml");
    Settings settings = default_settings(scene);
    for (const std::string& assignment :
         {std::string("stage=pixel_light"), std::string("coverage=edge_functions"),
          std::string("fill_rule=top_left"), std::string("snap=subpixel"), "shading=" + shading})
        set_from_text(settings, assignment);
    std::vector<bool> covered;
    for (const int owner : draw_frame(prepare_frame(scene, settings)).owner)
        covered.push_back(owner >= 0);
    return covered;
}

} // namespace

PREDICTIONS_TEST("Look back on lesson 18: no bit in common", "20-bresenham", "look-back") {
    std::vector<std::set<int>> codes;
    for (const glm::dvec2 corner : {glm::dvec2(-1.7, -1.4), {1.7, 1.35}, {1.6, 1.4}})
        codes.push_back(sides_it_is_beyond(corner));
    bool has_common = false, are_all_inside = true;
    for (int side = 0; side < 4; ++side) {
        has_common = has_common || (codes[0].count(side) == 1 && codes[1].count(side) == 1 &&
                                    codes[2].count(side) == 1);
    }
    for (const std::set<int>& code : codes) {
        CHECK_FALSE(code.empty());
        are_all_inside = are_all_inside && code.empty();
    }
    // The middle of the needle is in the picture.
    CHECK(sides_it_is_beyond({0.0, 0.0}).empty());
    require_look_back("20-bresenham", {has_common, are_all_inside, !has_common && !are_all_inside});
}

PREDICTIONS_TEST("Look back on lesson 19: turning does not cull", "21-edge-functions",
                 "look-back") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    const glm::dvec3 camera(0.0, 0.0, -3.001);
    int away = 0;
    for (int i = 0; i < scene.mesh.triangle_count(); ++i) {
        const Vertex& corner = scene.mesh.corner(i, 0);
        if (glm::dot(glm::dvec3(corner.normal), glm::dvec3(corner.position) - camera) > 0.0) ++away;
    }
    // Neither the normals nor the camera's position change with the yaw.
    require_look_back("21-edge-functions", {away<10, away == 10, away> 10});
}

PREDICTIONS_TEST("Look back on lesson 20: sums of integers", "22-weights", "look-back") {
    int missed = 0, all = 0;
    for (int l = 1; l < 500; ++l) {
        for (int s = 0; s <= l; s += 7) {
            ++all;
            if (end_by_integers(l, s) != std::pair(l, s)) ++missed;
        }
    }
    require_look_back("22-weights",
                      {missed == 0, missed > 0 && missed < all / 4, missed >= all / 4});
}

PREDICTIONS_TEST("Look back on lesson 21: one of two neighbours", "23-textures", "look-back") {
    // They walk along their edge in opposite directions.
    int none = 0, one = 0, both = 0;
    for (int dx = -5; dx <= 5; ++dx) {
        for (int dy = -5; dy <= 5; ++dy) {
            if (dx == 0 && dy == 0) continue;
            const int claims =
                (takes_its_edge(dx, dy) ? 1 : 0) + (takes_its_edge(-dx, -dy) ? 1 : 0);
            ++(claims == 0 ? none : claims == 1 ? one : both);
        }
    }
    require_look_back("23-textures", {both > 0, none == 0 && both == 0 && one == 120, none > 0});
}

PREDICTIONS_TEST("Look back on lesson 22: the opposite edge", "24-mipmaps", "look-back") {
    const std::array<glm::dvec2, 3> v{{{2, 1}, {14, 1}, {5, 10}}};
    const glm::dvec2 p(8, 5);
    const std::array<double, 3> at_edge{doubled_area(v[0], v[1], p), doubled_area(v[1], v[2], p),
                                        doubled_area(v[2], v[0], p)};
    const double all = doubled_area(v[0], v[1], v[2]);
    // Weighted with the right areas, the corners give the pixel back.
    const auto gives_pixel = [&](std::size_t first) {
        glm::dvec2 sum(0.0);
        for (std::size_t i = 0; i < 3; ++i)
            sum += v[i] * (at_edge[(first + i) % 3] / all);
        return glm::length(sum - p) < 1e-9;
    };
    require_look_back("24-mipmaps", {gives_pixel(0), gives_pixel(1), gives_pixel(2)});
}

PREDICTIONS_TEST("Look back on lesson 23: u halfway on the screen", "25-z-fighting", "look-back") {
    const double depth = 2.0 / (1.0 / 2.0 + 1.0 / 4.0);
    const double u = (depth - 2.0) / (4.0 - 2.0);
    REQUIRE(u == Approx(1.0 / 3.0));
    require_look_back("25-z-fighting", {u < 0.48, u >= 0.48 && u <= 0.52, u > 0.52});
}

PREDICTIONS_TEST("Look back on lesson 24: doublings", "26-hidden-surfaces", "look-back") {
    int level = 0;
    for (double texel = 1.0; texel < 4.0; texel *= 2.0)
        ++level;
    require_look_back("26-hidden-surfaces", {level == 1, level == 2, level == 4});
}

PREDICTIONS_TEST("Look back on lesson 25: the same number in the buffer", "27-flat-gouraud-phong",
                 "look-back") {
    // At depth 4, 0.001 is less than one step of 16 bits of NDC z, so two depths can be the same.
    const double step = 1.0 / 65535.0;
    const double lead = 0.001 * 100.0 * 0.1 / (100.0 - 0.1) / (4.0 * 4.0);
    REQUIRE(lead < step);
    const double first = 0.976028, second = first, empty = 1.0;
    const bool passes_first = first < empty, passes_second = second < first;
    require_look_back("27-flat-gouraud-phong", {passes_second, passes_first && !passes_second,
                                                !passes_first && !passes_second});
}

PREDICTIONS_TEST("Look back on lesson 27: the outline of a drum", "29-normal-maps", "look-back") {
    const std::vector<bool> flat = covered_by_drum("flat"), smooth = covered_by_drum("phong");
    const auto count = [](const std::vector<bool>& pixels) {
        return std::count(pixels.begin(), pixels.end(), true);
    };
    require_look_back("29-normal-maps",
                      {count(smooth) > count(flat), count(smooth) < count(flat), smooth == flat});
}

PREDICTIONS_TEST("Look back on lesson 28: a normal that is too short", "30-obj", "look-back") {
    double left = 1.0;
    for (int i = 0; i < 50; ++i)
        left *= 0.87;
    require_look_back("30-obj", {left > 0.8, left > 0.3 && left <= 0.8, left < 0.001});
}

PREDICTIONS_TEST("Look back on lesson 29: the normal of a roof that is stretched", "31-shadows",
                 "look-back") {
    // It is perpendicular to the way up the roof, which was (0, -1, 1).
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.0, -2.0, 1.0));
    const glm::dvec3 along(1.0, 0.0, 0.0);
    glm::dvec3 normal = glm::normalize(glm::cross(up, along));
    if (normal.y > 0.0) normal = -normal;
    const double before = -std::sqrt(0.5);
    require_look_back("31-shadows", {normal.y > before + 0.1, normal.y < before - 0.1,
                                     std::abs(normal.y - before) < 0.1});
}

PREDICTIONS_TEST("Look back on lesson 30: the vertices of a cube", "32-blending", "look-back") {
    std::set<std::pair<int, int>> vertices; // a point, by its bits, and a side
    for (int point = 0; point < 8; ++point) {
        for (int axis = 0; axis < 3; ++axis)
            vertices.emplace(point, 2 * axis + ((point >> axis) & 1));
    }
    const std::size_t count = vertices.size();
    require_look_back("32-blending", {count == 8, count == 24, count == 36});
}

PREDICTIONS_TEST("Look back on lesson 31: a ray that starts on its surface", "33-cost",
                 "look-back") {
    // Points on the plane x + y + z = 1, computed in float: some come out below it.
    int below = 0;
    for (int i = 1; i < 100; ++i) {
        for (int j = 1; i + j < 100; ++j) {
            const float x = static_cast<float>(i) / 100.0f, y = static_cast<float>(j) / 100.0f;
            const float z = 1.0f - x - y;
            if (static_cast<double>(x) + static_cast<double>(y) + static_cast<double>(z) < 1.0)
                ++below;
        }
    }
    require_look_back("33-cost", {below == 0, below > 0, false});
}

PREDICTIONS_TEST("Look back on lesson 32: the pane that is drawn last", "34-simd", "look-back") {
    const glm::dvec3 white(1.0), red(1.0, 0.0, 0.0), blue(0.0, 0.0, 1.0);
    const double alpha = 0.25;
    const glm::dvec3 first = alpha * blue + (1.0 - alpha) * white;
    const glm::dvec3 both = alpha * red + (1.0 - alpha) * first;
    require_look_back("34-simd", {both.b > both.r + 0.01, std::abs(both.r - both.b) <= 0.01,
                                  both.r > both.b + 0.01});
}

PREDICTIONS_TEST("Look back on lesson 33: colours after a pre-pass", "35-rays", "look-back") {
    // Everything is covered but for row 0 and column 0: each of those pixels has one nearest depth.
    const int colours = 499 * 499, fragments = 328789, pixels = 500 * 500;
    require_look_back("35-rays", {colours == fragments, colours == pixels - 999, colours > pixels});
}

PREDICTIONS_TEST("Look back on lesson 34: what depth first spares", "36-your-own-program",
                 "look-back") {
    // Of the room's fragments these fail, counted in lesson 10: their light is not needed.
    const double failing = 35432.0, fragments = 328789.0, share = failing / fragments;
    require_look_back("36-your-own-program",
                      {share == 0.0, std::abs(share - 1.0 / 9.0) < 0.01, share > 0.4});
}
