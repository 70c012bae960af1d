#include "stages/triangle_tree.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace tree_tests {

glm::vec3 random_place(test::Random& random, double size) {
    return {random.number(-size, size), random.number(-size, size), random.number(-size, size)};
}

/// Small triangles here and there, large ones, and walls along an axis.
Mesh random_mesh(test::Random& random, int triangles) {
    Mesh mesh;
    for (int t = 0; t < triangles; ++t) {
        const glm::vec3 place = random_place(random, 5.0);
        const double size = t % 7 == 0 ? 6.0 : 0.4;
        std::array<Vertex, triangle_corners> corners{};
        for (Vertex& corner : corners) {
            corner.position = place + random_place(random, size);
            if (t % 3 == 0) corner.position[t % 9 / 3] = place[t % 9 / 3];
        }
        if (t % 31 == 0) corners[2] = corners[1]; // no area
        mesh.add_triangle_of(corners);
    }
    return mesh;
}

/// The first triangle that a ray meets, found by testing every one.
TriangleHit first_hit_of_all(const Mesh& mesh, const WorldRay& ray) {
    TriangleHit hit;
    for (int i = 0; i < mesh.triangle_count(); ++i) {
        const glm::vec3& a = mesh.corner(i, 0).position;
        const TriangleMeeting meeting =
            intersect(ray, {a, mesh.corner(i, 1).position - a, mesh.corner(i, 2).position - a});
        if (meeting.t < hit.t) hit = {meeting, i};
    }
    return hit;
}

TEST_CASE("A ray meets the same triangle with boxes and without") {
    test::Random random(7);
    const std::array rounds{test::rounds(3'000, 300), 40, 20};
    int hits = 0, misses = 0, r = 0;
    for (const int triangles : {300, 5, 1}) {
        const Mesh mesh = random_mesh(random, triangles);
        const TriangleTree tree(mesh);
        for (int i = 0; i < rounds[static_cast<std::size_t>(r)]; ++i) {
            WorldRay ray{random_place(random, 7.0), random_place(random, 7.0), 1.0f};
            if (i % 5 == 0) ray.direction[i % 3] = 0.0f;
            if (i % 11 == 0) ray.end = std::numeric_limits<float>::infinity();
            // From a corner, and along an edge.
            if (i % 4 == 0) ray.from = mesh.corner(i % triangles, i % 3).position;
            if (i % 8 == 0)
                ray.direction = mesh.corner(i % triangles, (i + 1) % 3).position - ray.from;
            const TriangleHit found = tree.first_hit(ray), all = first_hit_of_all(mesh, ray);
            if (found.triangle != all.triangle || (found.is_hit() && found.t != all.t))
                FAIL("ray " << i << " meets triangle " << found.triangle << " at " << found.t
                            << ", without boxes " << all.triangle << " at " << all.t);
            ++(all.is_hit() ? hits : misses);
        }
        ++r;
    }
    CHECK(hits > 100);
    CHECK(misses > 50);
}

TEST_CASE("A ray meets a triangle where its plane and weights in double say") {
    test::Random random(8);
    int met = 0, missed = 0, ties = 0;
    for (int i = 0; i < test::rounds(6'000, 3'000); ++i) {
        const glm::vec3 a = random_place(random, 2.0), b = random_place(random, 2.0),
                        c = random_place(random, 2.0);
        const WorldRay ray{random_place(random, 4.0), random_place(random, 8.0), 1.0f};
        const float t = intersect(ray, {a, b - a, c - a}).t;
        const glm::dvec3 da(a), db(b), dc(c), from(ray.from), way(ray.direction);
        const glm::dvec3 normal = glm::cross(db - da, dc - da);
        const double wanted = glm::dot(normal, da - from) / glm::dot(normal, way);
        const glm::dvec3 at = from + way * wanted;
        // The weight of a corner is the area of the other two and the place, over the whole area.
        const auto weight = [&](const glm::dvec3& p, const glm::dvec3& q) {
            return glm::dot(normal, glm::cross(p - at, q - at)) / glm::dot(normal, normal);
        };
        const double least =
            std::min({weight(db, dc), weight(dc, da), weight(da, db), wanted, 1.0 - wanted});
        if (std::abs(least) < 1e-4) {
            ++ties;
            continue;
        }
        if (std::isfinite(t) != (least > 0.0))
            FAIL("ray " << i << " meets at " << t << ", in double at " << wanted << " with "
                        << least);
        if (std::isfinite(t)) CHECK(std::abs(t - wanted) < 1e-3);
        ++(std::isfinite(t) ? met : missed);
    }
    CHECK(met > 5);
    CHECK(missed > 50);
    CHECK(ties < missed / 20);
}

TEST_CASE("A ray stops at its ends, meets both sides, and edges belong to a triangle") {
    const RayTriangle wall{{0, 0, 2}, {4, 0, 0}, {0, 4, 0}};
    const auto t_of = [&](const glm::vec3& from, const glm::vec3& way, float end = 1.0f) {
        return intersect({from, way, end}, wall).t;
    };
    constexpr float nowhere = std::numeric_limits<float>::infinity();
    CHECK(t_of({1, 1, 0}, {0, 0, 4}) == 0.5f);
    CHECK(t_of({1, 1, 4}, {0, 0, -4}) == 0.5f);
    CHECK(t_of({1, 1, 0}, {0, 0, 2}) == nowhere); // it ends on it
    CHECK(t_of({1, 1, 0}, {0, 0, 1}) == nowhere);
    CHECK(t_of({1, 1, 0}, {0, 0, 1}, nowhere) == 2.0f);
    CHECK(t_of({1, 1, 2}, {0, 0, 1}) == nowhere); // it begins on it
    CHECK(t_of({0, 1, 0}, {0, 0, 4}) == 0.5f);    // on an edge
    CHECK(t_of({0, 0, 0}, {0, 0, 4}) == 0.5f);    // at a corner
    CHECK(t_of({2, 2, 0}, {0, 0, 4}) == 0.5f);
    CHECK(t_of({2.5f, 2, 0}, {0, 0, 4}) == nowhere);
    CHECK(t_of({1, 1, 2}, {1, 0, 0}) == nowhere); // along it
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(t_of({nan, 1, 0}, {0, 0, 4}) == nowhere);
    CHECK(t_of({1, 1, 0}, {nan, 0, 4}) == nowhere);
}

TEST_CASE("A ray meets the first of coinciding triangles, and none in an empty mesh") {
    Mesh mesh;
    CHECK_FALSE(TriangleTree(mesh).first_hit({{0, 0, 0}, {0, 0, 1}, 1.0f}).is_hit());
    for (int i = 0; i < 20; ++i)
        mesh.add_triangle_of({Vertex{{-1, -1, 1}}, Vertex{{3, -1, 1}}, Vertex{{-1, 3, 1}}});
    const TriangleTree tree(mesh);
    const TriangleHit hit = tree.first_hit({{0, 0, 0}, {0, 0, 4}, 1.0f});
    CHECK(hit.triangle == 0);
    CHECK(hit.t == 0.25f);
    CHECK(tree.is_of(mesh));
    mesh.place_corner(13, 2, {-1, 3, 1.5f});
    CHECK_FALSE(tree.is_of(mesh));
    mesh.add_triangle_of({});
    CHECK_FALSE(tree.is_of(mesh));
}

} // namespace tree_tests
} // namespace
