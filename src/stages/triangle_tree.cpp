#include "stages/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// A box of no more triangles than this is not divided.
constexpr int few_triangles = 4;

/// A box is larger than its contents by this fraction of its coordinates. The points at which rays
/// meet triangles are off by some units in the last place; no box may miss one because of that.
constexpr float box_margin = 1e-5f;

RayTriangle ray_triangle(const Mesh& mesh, int triangle) {
    const glm::vec3& a = mesh.corner(triangle, 0).position;
    return {a, mesh.corner(triangle, 1).position - a, mesh.corner(triangle, 2).position - a};
}

/// Does the ray pass through the box before t?
bool passes(const WorldRay& ray, const glm::vec3& low, const glm::vec3& high, float before) {
    float enters = 0.0f, leaves = before;
    for (int i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0.0f) {
            if (!(ray.from[i] >= low[i] && ray.from[i] <= high[i])) return false;
            continue;
        }
        const float to_low = (low[i] - ray.from[i]) / ray.direction[i];
        const float to_high = (high[i] - ray.from[i]) / ray.direction[i];
        enters = std::max(enters, std::min(to_low, to_high));
        leaves = std::min(leaves, std::max(to_low, to_high));
    }
    return enters <= leaves;
}

} // namespace

TriangleMeeting intersect(const WorldRay& ray, const RayTriangle& triangle) {
    // Cramer's rule for from + t way = a + u ab + v ac. Written so that NaN meets nothing.
    const glm::vec3 across = glm::cross(ray.direction, triangle.ac);
    const float whole = glm::dot(triangle.ab, across);
    if (!(whole > 0.0f || whole < 0.0f)) return {};
    const glm::vec3 from_a = ray.from - triangle.a;
    const float u = glm::dot(from_a, across) / whole;
    if (!(u >= 0.0f && u <= 1.0f)) return {};
    const glm::vec3 across_edge = glm::cross(from_a, triangle.ab);
    const float v = glm::dot(ray.direction, across_edge) / whole;
    if (!(v >= 0.0f && u + v <= 1.0f)) return {};
    const float t = glm::dot(triangle.ac, across_edge) / whole;
    if (!(t > 0.0f && t < ray.end)) return {};
    return {t, u, v};
}

TriangleTree::TriangleTree(const Mesh& mesh, TreeBoxes kind) {
    const int count = mesh.triangle_count();
    triangles_.reserve(static_cast<std::size_t>(count));
    order_.reserve(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        triangles_.push_back(ray_triangle(mesh, t));
        order_.push_back(t);
    }
    boxes_.emplace_back();
    fill(0, 0, count, kind == TreeBoxes::one ? count : few_triangles);
}

/// @param most triangles in a box that is not divided
void TriangleTree::fill(std::size_t box, int first, int count, int most) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    glm::vec3 low(infinite), high(-infinite);
    const auto begin = order_.begin() + first, end = begin + count;
    for (auto t = begin; t != end; ++t) {
        const RayTriangle& triangle = triangles_[static_cast<std::size_t>(*t)];
        for (const glm::vec3& way : {glm::vec3(0.0f), triangle.ab, triangle.ac}) {
            low = glm::min(low, triangle.a + way);
            high = glm::max(high, triangle.a + way);
        }
    }
    const glm::vec3 margin = box_margin * glm::max(glm::abs(low), glm::abs(high));
    const glm::vec3 size = high - low;
    boxes_[box] = {low - margin, high + margin, first, count};
    if (count <= most) return;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = [&](int t) {
        const RayTriangle& triangle = triangles_[static_cast<std::size_t>(t)];
        return 3.0f * triangle.a[axis] + triangle.ab[axis] + triangle.ac[axis];
    };
    const int half = count / 2;
    std::nth_element(begin, begin + half, end, [&](int a, int b) {
        const float at_a = middle(a), at_b = middle(b);
        return at_a != at_b ? at_a < at_b : a < b;
    });
    const std::size_t inner = boxes_.size();
    boxes_.resize(inner + 2);
    boxes_[box].first = static_cast<int>(inner);
    boxes_[box].count = 0;
    fill(inner, first, half, most);
    fill(inner + 1, first + half, count - half, most);
}

void TriangleTree::ask(const WorldRay& ray, int triangle, TriangleHit& hit) const {
    const TriangleMeeting meeting = intersect(ray, triangles_[static_cast<std::size_t>(triangle)]);
    const bool is_first = hit.is_hit() && triangle < hit.triangle;
    if (meeting.t < hit.t || (meeting.t == hit.t && is_first)) hit = {meeting, triangle};
}

TriangleHit TriangleTree::first_hit(const WorldRay& ray, const RaySearch& search) const {
    TriangleHit hit;
    RayCount count_here{.rays = 1};
    const auto is_meant = [&](int triangle) {
        return search.are_meant == nullptr ||
               (*search.are_meant)[static_cast<std::size_t>(triangle)] != 0;
    };
    if (triangles_.empty()) return hit;
    // Halving a million triangles makes no more than 20 levels.
    std::array<int, 64> waiting{};
    int count = 0;
    waiting[static_cast<std::size_t>(count++)] = 0;
    while (count > 0) {
        const auto which = static_cast<std::size_t>(waiting[static_cast<std::size_t>(--count)]);
        const Box& box = boxes_[which];
        ++count_here.boxes;
        if (!passes(ray, box.low, box.high, std::min(hit.t, ray.end))) continue;
        if (box.count == 0) {
            waiting[static_cast<std::size_t>(count++)] = box.first + 1;
            waiting[static_cast<std::size_t>(count++)] = box.first;
            continue;
        }
        for (int i = 0; i < box.count; ++i) {
            const int triangle = order_[static_cast<std::size_t>(box.first + i)];
            if (!is_meant(triangle)) continue;
            ++count_here.triangles;
            ask(ray, triangle, hit);
        }
    }
    if (search.count != nullptr) *search.count += count_here;
    return hit;
}

bool TriangleTree::is_of(const Mesh& mesh) const {
    if (static_cast<int>(triangles_.size()) != mesh.triangle_count()) return false;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (!(triangles_[static_cast<std::size_t>(t)] == ray_triangle(mesh, t))) return false;
    }
    return true;
}

} // namespace rasterwalk
