// Polygons cut into triangles, checked for what any correct cut has: the polygon's area, and each
// point of a grid in one triangle if it is in the polygon, in none if it is outside.

#include "scene/polygon_cutter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "base/limits.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random.h"

using namespace rasterwalk;

namespace {

double cross_at(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Even-odd: how often a ray to the right crosses the edges.
bool is_inside(const std::vector<glm::vec3>& polygon, const glm::dvec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i]), b(polygon[(i + 1) % polygon.size()]);
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

int triangles_over(const PolygonCutter& cutter, const std::vector<glm::vec3>& polygon,
                   const glm::dvec2& p) {
    int count = 0;
    for (const auto& triangle : cutter.triangles()) {
        const auto at = [&](std::size_t i) {
            return glm::dvec2(polygon[static_cast<std::size_t>(triangle[i])]);
        };
        const double e0 = cross_at(at(0), at(1), p), e1 = cross_at(at(1), at(2), p),
                     e2 = cross_at(at(2), at(0), p);
        count += e0 > 0 && e1 > 0 && e2 > 0 ? 1 : 0;
    }
    return count;
}

/// Every point of a grid that no edge goes through.
void check_cover(const PolygonCutter& cutter, const std::vector<glm::vec3>& polygon) {
    constexpr int steps = 23;
    for (int i = 0; i < steps * steps; ++i) {
        const glm::dvec2 p(-1.0387 + 2.09 * (i % steps) / steps,
                           -1.0411 + 2.09 * (i / steps) / steps);
        const int wanted = is_inside(polygon, p) ? 1 : 0;
        const int found = triangles_over(cutter, polygon, p);
        INFO("at " << p.x << ", " << p.y);
        if (found != wanted) CHECK(found == wanted);
    }
}

/// A polygon that never crosses itself: each corner in its own direction from the middle.
std::vector<glm::vec3> star_of(test::Random& random, int corners) {
    std::vector<glm::vec3> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * (i + random.real(0.1, 0.9)) / corners;
        const double radius = random.real(0.1, 1.0);
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return polygon;
}

/// Two spiral arms, one inside the other: no fan and few ears.
std::vector<glm::vec3> spiral_of(int corners) {
    std::vector<glm::vec3> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 12.0 * i / corners, radius = 0.15 + 0.8 * i / corners;
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    for (int i = corners; i-- > 0;) {
        const double angle = 12.0 * i / corners, radius = 0.1 + 0.8 * i / corners;
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return polygon;
}

} // namespace

TEST_CASE("A polygon's triangles cover it once and nothing else") {
    test::Random random(301);
    PolygonCutter cutter;
    int fans = 0, ears = 0;
    const int count = test::rounds(200, 20);
    for (int i = 0; i < count; ++i) {
        INFO("polygon " << i);
        std::vector<glm::vec3> polygon = star_of(random, random.integer(4, 14));
        const PolygonCut how = cutter.cut(polygon);
        REQUIRE((how == PolygonCut::fan || how == PolygonCut::ears));
        (how == PolygonCut::fan ? fans : ears) += 1;
        CHECK(cutter.triangles().size() == polygon.size() - 2);
        check_cover(cutter, polygon);
    }
    CHECK(fans > 0);
    CHECK(ears > 0);
}

TEST_CASE("A spiral is cut ear by ear") {
    PolygonCutter cutter;
    const std::vector<glm::vec3> polygon = spiral_of(40);
    CHECK(cutter.cut(polygon) == PolygonCut::ears);
    CHECK(cutter.triangles().size() == polygon.size() - 2);
    check_cover(cutter, polygon);
}

TEST_CASE("A polygon of any plane is cut as it is seen from its front, and goes round as given") {
    test::Random random(302);
    PolygonCutter cutter;
    for (int i = 0; i < test::rounds(50, 8); ++i) {
        const std::vector<glm::vec3> flat = star_of(random, 9);
        const glm::vec3 u = glm::normalize(
            glm::vec3(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)));
        const glm::vec3 v = glm::normalize(glm::cross(u, glm::vec3(0.3f, 0.5f, -0.7f)));
        std::vector<glm::vec3> polygon;
        for (const glm::vec3& p : flat)
            polygon.push_back(p.x * u + p.y * v + glm::vec3(3, -2, 5));
        cutter.cut(polygon);
        // The triangles' areas, as vectors, sum up to the polygon's, and none points against it.
        const glm::dvec3 whole = newell_normal(polygon);
        glm::dvec3 sum(0.0);
        for (const auto& triangle : cutter.triangles()) {
            const auto at = [&](std::size_t k) {
                return glm::dvec3(polygon[static_cast<std::size_t>(triangle[k])]);
            };
            const glm::dvec3 area = glm::cross(at(1) - at(0), at(2) - at(0));
            CHECK(glm::dot(area, whole) > -1e-5);
            sum += area;
        }
        CHECK(glm::length(sum - whole) < 1e-5);
    }
}

TEST_CASE("A hole that is joined to its outline stays a hole") {
    const std::vector<glm::vec3> polygon{
        {-1, -1, 0},       {1, -1, 0},       {1, 1, 0},       {-1, 1, 0},       {-1, -1, 0},
        {-0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, -0.5f, 0}};
    PolygonCutter cutter;
    CHECK(cutter.cut(polygon) == PolygonCut::ears);
    CHECK(cutter.triangles().size() == polygon.size() - 2);
    check_cover(cutter, polygon);
}

TEST_CASE("Polygons without an inside are cut as well") {
    PolygonCutter cutter;
    const std::vector<glm::vec3> one_point(7, glm::vec3(2, 3, 4));
    CHECK(cutter.cut(one_point) == PolygonCut::fan);
    CHECK(cutter.triangles().size() == 5);
    std::vector<glm::vec3> line;
    for (const float x : {0.0f, 5.0f, 1.0f, 4.0f, 2.0f, 3.0f})
        line.emplace_back(x, 2 * x, -x);
    cutter.cut(line);
    CHECK(cutter.triangles().size() == 4);
}

TEST_CASE("The work of all polygons together has an end") {
    PolygonCutter cutter;
    const std::vector<glm::vec3> spiral = spiral_of(static_cast<int>(most_ear_corners) / 2);
    // Each costs at least one test of each reflex corner for each ear.
    const long long least = static_cast<long long>(most_ear_corners) * most_ear_corners / 8;
    int cut = 0;
    while (cutter.cut(spiral) != PolygonCut::refused) {
        CHECK(cutter.triangles().size() == spiral.size() - 2);
        REQUIRE(++cut <= most_ear_tests / least);
    }
    CHECK(cut > 0);
    CHECK(cutter.triangles().empty());
    const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    CHECK(cutter.cut(square) == PolygonCut::fan);
}
