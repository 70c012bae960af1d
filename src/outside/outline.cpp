#include "outside/outline.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// From this cosine up, two directions are the same.
constexpr float same_direction = 0.999f;

/// An edge of one triangle, its ends in order.
struct OutlineSide {
    glm::vec3 from, to;
    int triangle;

    auto ends() const { return std::tie(from.x, from.y, from.z, to.x, to.y, to.z); }
};

bool is_before(const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

glm::vec3 normal_of(const Scene& scene, int triangle) {
    return face_normal(scene.corner(triangle, 0).position, scene.corner(triangle, 1).position,
                       scene.corner(triangle, 2).position);
}

/// Are these triangles in one plane, like two halves of a wall?
bool is_flat(const Scene& scene, int a, int b) {
    return part_of(scene, a) == part_of(scene, b) &&
           std::abs(glm::dot(normal_of(scene, a), normal_of(scene, b))) > same_direction;
}

std::vector<OutlineSide> sides_of(const Scene& scene) {
    std::vector<OutlineSide> sides;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        for (int i = 0; i < triangle_corners; ++i) {
            glm::vec3 from = scene.corner(t, i).position;
            glm::vec3 to = scene.corner(t, (i + 1) % triangle_corners).position;
            const glm::vec3 sum = from + to;
            if (!std::isfinite(sum.x + sum.y + sum.z)) continue; // NaN has no place in an order
            if (is_before(to, from)) std::swap(from, to);
            sides.push_back({from, to, t});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const OutlineSide& a, const OutlineSide& b) { return a.ends() < b.ends(); });
    return sides;
}

} // namespace

std::vector<OutlineEdge> outline_of(const Scene& scene) {
    std::vector<OutlineEdge> outline;
    if (scene.triangle_count() > most_outlined) return outline;
    const std::vector<OutlineSide> sides = sides_of(scene);
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].ends() == sides[i].ends())
            ++end;
        const bool is_inner =
            end - i == 2 && is_flat(scene, sides[i].triangle, sides[i + 1].triangle);
        if (!is_inner) outline.push_back({sides[i].from, sides[i].to});
        i = end;
    }
    return outline;
}

} // namespace rasterwalk
