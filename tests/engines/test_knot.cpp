#include "engines/knot.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The knot has 200,000 triangles that close a surface") {
    const Scene knot = knot_scene();
    REQUIRE(knot.triangle_count() == 200'000);
    // Each edge is walked once in each direction.
    std::vector<std::pair<int, int>> there, back;
    for (const TriangleIndices& triangle : knot.mesh.triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = triangle[i], to = triangle[(i + 1) % 3];
            there.emplace_back(from, to);
            back.emplace_back(to, from);
        }
    }
    std::sort(there.begin(), there.end());
    std::sort(back.begin(), back.end());
    CHECK(std::adjacent_find(there.begin(), there.end()) == there.end());
    CHECK(there == back);
    // A closed surface that is a torus: V - E + F = 0.
    CHECK(static_cast<int>(knot.mesh.vertices().size()) - 300'000 + 200'000 == 0);
}

TEST_CASE("The knot's triangles face outward, and its normals are those of its surface") {
    const Scene knot = knot_scene();
    // The volume that the triangles enclose: positive if face_normal() points out of it.
    double volume = 0.0;
    int against = 0, not_unit = 0, without_area = 0;
    for (int t = 0; t < knot.triangle_count(); ++t) {
        const glm::vec3 &a = knot.corner(t, 0).position, &b = knot.corner(t, 1).position,
                        &c = knot.corner(t, 2).position;
        const glm::vec3 face = face_normal(a, b, c);
        without_area += face == glm::vec3(0.0f);
        volume += glm::dot(glm::dvec3(a), glm::cross(glm::dvec3(c), glm::dvec3(b))) / 6.0;
        for (int i = 0; i < 3; ++i) {
            const glm::vec3& normal = knot.corner(t, i).normal;
            against += glm::dot(normal, face) <= 0.0f;
            not_unit += std::abs(glm::length(normal) - 1.0f) > 1e-5f;
        }
    }
    CHECK(without_area == 0);
    CHECK(against == 0);
    CHECK(not_unit == 0);
    // For a tube without bumps: pi r^2 times the length of its middle curve.
    double length = 0.0;
    const auto middle = [](double u) {
        const double r = 0.62 + 0.22 * std::cos(3 * u);
        return glm::dvec3(r * std::cos(2 * u), r * std::sin(2 * u), 0.28 * std::sin(3 * u));
    };
    constexpr int steps = 10'000;
    const double pi = std::acos(-1.0);
    for (int i = 0; i < steps; ++i)
        length += glm::distance(middle(2 * pi * i / steps), middle(2 * pi * (i + 1) / steps));
    CHECK(volume == Approx(0.13 * 0.13 * pi * length).epsilon(0.02));
}
