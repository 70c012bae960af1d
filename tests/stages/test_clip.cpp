// Clipping, compared with another method: in the plane of the triangle each plane of the view is a
// line, and what is left of the triangle is the intersection of all half planes. Every two of the
// lines are intersected in double, and the points in all half planes are its corners.

#include "stages/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "stages/reject.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A corner of a triangle whose varying `colour` is its barycentric coordinates.
ClipVertex corner(int number, const glm::vec3& camera_space, float focal_length) {
    VertexRules rules;
    rules.camera.focal_length = focal_length;
    ClipVertex vertex;
    vertex.position_clip = to_clip_space(camera_space, rules);
    vertex.varyings.colour = glm::vec3(0.0f);
    vertex.varyings.colour[number] = 1.0f;
    return vertex;
}

VertexRules rules_of(Viewport size) {
    VertexRules rules;
    rules.viewport = size;
    rules.camera.focal_length = static_cast<float>(size.height);
    return rules;
}

std::vector<ClipVertex> random_triangle(Random& random, const VertexRules& rules) {
    std::vector<ClipVertex> corners;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 place(random.number(-3, 3), random.number(-3, 3), random.number(-1, 3));
        corners.push_back(corner(i, place, rules.camera.focal_length));
    }
    return corners;
}

/// Barycentric coordinates in the plane u + v + w = 1, as u and v.
using Place = glm::dvec2;

Place place_of(const ClipVertex& vertex) {
    return {vertex.varyings.colour.x, vertex.varyings.colour.y};
}

/// a u + b v + c >= 0.
struct HalfPlane {
    double a, b, c;
    double at(const Place& p) const { return a * p.x + b * p.y + c; }
};

double distance(const glm::vec4& plane, const ClipVertex& vertex) {
    return glm::dot(glm::dvec4(plane), glm::dvec4(vertex.position_clip));
}

/// The half planes of a triangle and of the first `count` planes.
std::vector<HalfPlane> half_planes(const std::vector<ClipVertex>& triangle,
                                   const ClipPlanes& planes, std::size_t count) {
    std::vector<HalfPlane> all{{1, 0, 0}, {0, 1, 0}, {-1, -1, 1}};
    for (std::size_t p = 0; p < count; ++p) {
        const double d0 = distance(planes[p], triangle[0]), d1 = distance(planes[p], triangle[1]),
                     d2 = distance(planes[p], triangle[2]);
        const double scale = std::max({std::abs(d0), std::abs(d1), std::abs(d2), 1e-30});
        all.push_back({(d0 - d2) / scale, (d1 - d2) / scale, d2 / scale});
    }
    return all;
}

/// Twice the area of the convex hull of the points.
double hull_area(std::vector<Place> points) {
    if (points.size() < 3) return 0.0;
    Place middle(0.0);
    for (const Place& p : points)
        middle += p / static_cast<double>(points.size());
    std::sort(points.begin(), points.end(), [&](const Place& p, const Place& q) {
        return std::atan2(p.y - middle.y, p.x - middle.x) <
               std::atan2(q.y - middle.y, q.x - middle.x);
    });
    double area = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Place a = points[i] - middle, b = points[(i + 1) % points.size()] - middle;
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

/// Twice the area of the intersection of all half planes.
double common_area(const std::vector<HalfPlane>& all) {
    std::vector<Place> points;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            const double determinant = all[i].a * all[j].b - all[i].b * all[j].a;
            if (std::abs(determinant) < 1e-14) continue;
            const Place p((all[i].b * all[j].c - all[j].b * all[i].c) / determinant,
                          (all[j].a * all[i].c - all[i].a * all[j].c) / determinant);
            if (std::all_of(all.begin(), all.end(),
                            [&](const HalfPlane& half) { return half.at(p) >= -1e-9; }))
                points.push_back(p);
        }
    }
    return hull_area(points);
}

/// Twice the signed area of a polygon in its own order.
double polygon_area(const std::vector<ClipVertex>& corners) {
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place a = place_of(corners[i]), b = place_of(corners[(i + 1) % corners.size()]);
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

using ClipFunction = decltype(&clip_nothing);

/// Clips random triangles both ways.
void check_against_half_planes(ClipFunction clip, const ClipPlanes& planes, std::size_t count,
                               const VertexRules& rules, int seed) {
    Random random(static_cast<unsigned>(seed));
    const ViewVolume volume(rules);
    int whole = 0, cut = 0, gone = 0;
    std::size_t most = 0;
    const int triangles = rounds(300'000, 20'000);
    for (int i = 0; i < triangles; ++i) {
        const std::vector<ClipVertex> triangle = random_triangle(random, rules);
        std::vector<ClipVertex> corners = triangle;
        const Clipped clipped = clip(corners, volume, nullptr);
        const double expected = common_area(half_planes(triangle, planes, count));
        const bool is_gone = clipped.rejection == Rejection::clipped_away;
        const double area = is_gone ? 0.0 : polygon_area(corners);
        (is_gone ? gone : clipped.is_cut ? cut : whole) += 1;
        if (!is_gone) most = std::max(most, corners.size());
        if (std::abs(area - expected) > 2e-5) {
            FAIL("triangle " << i << ": area " << area << ", by half planes " << expected);
        }
        if (is_gone) continue;
        for (const ClipVertex& v : corners) {
            for (std::size_t p = 0; p < count; ++p) {
                const glm::vec4& plane = planes[p];
                const double size =
                    glm::dot(glm::abs(glm::dvec4(plane)), glm::abs(glm::dvec4(v.position_clip)));
                if (distance(plane, v) < -1e-5 * (size + 1.0))
                    FAIL("triangle " << i << ": a corner beyond plane " << p);
            }
        }
    }
    CHECK(whole > 0);
    CHECK(cut > triangles / 20);
    CHECK(gone > triangles / 50);
    CHECK(most <= 3 + count);
}

} // namespace

TEST_CASE("The part of a triangle left by clipping is the intersection of all half planes") {
    const VertexRules rules = rules_of({500, 400});
    check_against_half_planes(clip_near, view_planes(rules), 1, rules, 71);
    check_against_half_planes(clip_all, view_planes(rules), clip_plane_count, rules, 72);
}

TEST_CASE("The guard band is clipped by its own planes, and by none if a triangle is within it") {
    const VertexRules rules = rules_of({500, 400});
    std::vector<ClipVertex> beside{corner(0, {-2.0f, 0.0f, 1.0f}, 400.0f),
                                   corner(1, {2.0f, 1.0f, 1.0f}, 400.0f),
                                   corner(2, {2.0f, -1.0f, 2.0f}, 400.0f)};
    CHECK_FALSE(clip_guard_band(beside, ViewVolume(rules)).is_cut);
    CHECK(clip_all(beside, ViewVolume(rules)).is_cut);
    std::vector<ClipVertex> far_out{corner(0, {-100.0f, 0.0f, 1.0f}, 400.0f),
                                    corner(1, {2.0f, 1.0f, 1.0f}, 400.0f),
                                    corner(2, {2.0f, -1.0f, 2.0f}, 400.0f)};
    CHECK(clip_guard_band(far_out, ViewVolume(rules)).is_cut);
    CHECK(far_out.size() == 4);
    for (const ClipVertex& v : far_out)
        CHECK(std::abs(v.position_clip.x / v.position_clip.w) <= 8192.01f);
}

TEST_CASE("Two triangles that share an edge get the same bits where it is cut") {
    Random random(73);
    const VertexRules rules = rules_of({500, 400});
    int cuts = 0;
    for (int i = 0; i < rounds(100'000, 10'000); ++i) {
        std::vector<ClipVertex> one = random_triangle(random, rules);
        const std::vector<ClipVertex> other = random_triangle(random, rules);
        const auto plane = static_cast<ClipPlane>(random.integer(0, 5));
        // The edge runs the other way in the neighbour.
        const std::vector<ClipVertex> neighbour{one[1], one[0], other[2]};
        std::vector<ClipVertex> of_one, of_neighbour;
        clip_by_plane(one, view_planes(rules), plane, of_one);
        clip_by_plane(neighbour, view_planes(rules), plane, of_neighbour);
        const auto is_of_edge = [](const ClipVertex& v) {
            return v.varyings.colour.z == 0.0f && v.varyings.colour.x > 0.0f &&
                   v.varyings.colour.y > 0.0f;
        };
        const auto a = std::find_if(of_one.begin(), of_one.end(), is_of_edge);
        const auto b = std::find_if(of_neighbour.begin(), of_neighbour.end(), is_of_edge);
        REQUIRE((a == of_one.end()) == (b == of_neighbour.end()));
        if (a == of_one.end()) continue;
        ++cuts;
        REQUIRE(a->position_clip == b->position_clip);
        REQUIRE(a->varyings == b->varyings);
    }
    CHECK(cuts > 1000);
}

TEST_CASE("One corner behind leaves two triangles, two leave one, three leave nothing") {
    const VertexRules rules = rules_of({500, 500});
    const auto left_of = [&](float z0, float z1, float z2) {
        std::vector<ClipVertex> corners{corner(0, {0.0f, -1.0f, z0}, 500.0f),
                                        corner(1, {1.0f, 1.0f, z1}, 500.0f),
                                        corner(2, {-1.0f, 1.0f, z2}, 500.0f)};
        const Clipped clipped = clip_near(corners, ViewVolume(rules));
        return clipped.rejection == Rejection::clipped_away ? std::size_t{0} : corners.size();
    };
    CHECK(left_of(1, 1, 1) == 3);
    CHECK(left_of(-1, 1, 1) == 4);
    CHECK(left_of(-1, -1, 1) == 3);
    CHECK(left_of(-1, -1, -1) == 0);
    // A triangle that only touches the plane has no area in front of it.
    CHECK(left_of(rules.near, -1, -1) == 0);
    CHECK(left_of(rules.near, rules.near, -1) == 0);
    CHECK(left_of(rules.near, rules.near, 1) == 3);
}

TEST_CASE("t is measured from the corner inside") {
    const VertexRules rules = rules_of({500, 500});
    const ClipVertex inside = corner(0, {0.0f, 0.0f, 0.4f}, 500.0f);
    const ClipVertex outside = corner(1, {1.0f, 0.0f, -0.6f}, 500.0f);
    const glm::vec4 near = view_planes(rules)[0];
    const ClipVertex cut =
        cut_edge(inside, outside, inner_distance(near, inside), inner_distance(near, outside));
    CHECK(cut.varyings.colour.y == Approx(0.3f));
    CHECK(cut.position_clip.w == Approx(rules.near));
    CHECK(cut.position_clip.x == Approx(150.0f));
}

TEST_CASE("Triangles that reach a million units out are cut where they meet the plane") {
    Random random(75);
    const VertexRules rules = rules_of({500, 400});
    const ViewVolume volume(rules);
    int cuts = 0;
    for (int i = 0; i < rounds(100'000, 10'000); ++i) {
        const auto place = [&] {
            // Of every size from a hand's breadth to a million.
            const auto size = [&] {
                const double length = std::pow(10.0, static_cast<double>(random.number(-1, 6)));
                return static_cast<float>(random.integer(0, 1) == 0 ? length : -length);
            };
            return glm::vec3(size(), size(), size());
        };
        const std::vector<ClipVertex> edge{corner(0, place(), 400.0f), corner(1, place(), 400.0f)};
        const auto plane = static_cast<std::size_t>(random.integer(0, 5));
        const glm::vec4& coefficients = volume.view[plane];
        std::vector<ClipVertex> kept;
        clip_by_plane(edge, volume.view, static_cast<ClipPlane>(plane), kept);
        using Wide = glm::tvec4<long double>;
        const Wide a(edge[0].position_clip), b(edge[1].position_clip), c(coefficients);
        const long double d_a = glm::dot(c, a), d_b = glm::dot(c, b);
        if ((d_a >= 0) == (d_b >= 0) || kept.empty()) continue;
        const Wide exact = a + d_a / (d_a - d_b) * (b - a);
        const auto found = std::find_if(kept.begin(), kept.end(), [&](const ClipVertex& v) {
            return v.position_clip != edge[0].position_clip &&
                   v.position_clip != edge[1].position_clip;
        });
        if (found == kept.end()) continue; // the corner is on the plane, as far as float can show
        // Rounded once if it was far out; otherwise by float, as everywhere.
        const bool is_far = is_too_large_for_float(edge[0]) || is_too_large_for_float(edge[1]);
        if (!is_far) continue;
        for (int k = 0; k < 4; ++k) {
            const double wanted = static_cast<double>(exact[k]);
            const double error = std::abs(static_cast<double>(found->position_clip[k]) - wanted);
            // A hundredth of a pixel across the plane is this much along the edge: the precision of
            // a distance for which float is enough.
            const auto along = static_cast<double>((b[k] - a[k]) / (d_a - d_b));
            if (error > 1e-7 * std::abs(wanted) + 0.01 * std::abs(along) + 1e-5) {
                FAIL("edge " << i << ", plane " << plane << ", coordinate " << k << ": "
                             << found->position_clip[k] << ", exactly " << wanted);
            }
        }
        ++cuts;
    }
    CHECK(cuts > 1000);
}

TEST_CASE("Clipping leaves nothing of a triangle whose corners share an outcode") {
    Random random(74);
    const VertexRules rules = rules_of({500, 400});
    const ViewVolume volume(rules);
    int rejected = 0, missed = 0;
    for (int i = 0; i < rounds(100'000, 10'000); ++i) {
        std::vector<ClipVertex> corners = random_triangle(random, rules);
        const bool is_rejected = reject_by_outcodes(corners, volume) == Rejection::outside;
        const bool is_gone = clip_all(corners, volume).rejection == Rejection::clipped_away;
        if (is_rejected) REQUIRE(is_gone);
        rejected += is_rejected ? 1 : 0;
        missed += is_gone && !is_rejected ? 1 : 0;
    }
    CHECK(rejected > 1000);
    CHECK(missed > 10); // those that pass by a corner of the view
}
