#include "outside/world_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// The smallest share of its colour that a side can have: one edge-on to the light.
constexpr double shaded = 0.72;

const glm::dvec3 light_direction(0.36, -0.80, -0.48);

/// The brightness for the direction of a normal, 0..1.
float shade_of(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    if (!(length > 0.0)) return 1.0f;
    const double cosine = std::abs(glm::dot(normal, light_direction)) / length;
    return static_cast<float>(shaded + (1.0 - shaded) * cosine);
}

} // namespace

std::vector<WorldTriangle> world_triangles(const Scene& scene) {
    std::vector<WorldTriangle> triangles;
    triangles.reserve(static_cast<std::size_t>(scene.triangle_count()));
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const glm::vec3& a = scene.corner(t, 0).position;
        const glm::vec3& b = scene.corner(t, 1).position;
        const glm::vec3& c = scene.corner(t, 2).position;
        const glm::dvec3 first(a);
        const glm::dvec3 normal = glm::cross(glm::dvec3(c) - first, glm::dvec3(b) - first);
        const glm::vec3 sides = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
        triangles.push_back({a, normal, own_colour(scene, t) * shade_of(normal),
                             std::max({sides.x, sides.y, sides.z})});
    }
    return triangles;
}

bool is_culled(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& camera) {
    const glm::dvec3 corner(triangle.corner), normal(triangle.normal);
    return glm::dot(normal, eye - corner) <= 0.0 && glm::dot(normal, camera - corner) > 0.0;
}

glm::vec3 own_colour(const Scene& scene, int triangle) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < triangle_corners; ++i)
        sum += scene.corner(triangle, i).reflectance;
    return sum / static_cast<float>(triangle_corners);
}

std::array<glm::dvec3, triangle_corners> eye_corners(const Scene& scene, int triangle,
                                                     const OutsideEye& eye) {
    std::array<glm::dvec3, triangle_corners> corners;
    for (int i = 0; i < triangle_corners; ++i)
        corners[static_cast<std::size_t>(i)] = eye.in_eye(scene.corner(triangle, i).position);
    return corners;
}

} // namespace rasterwalk
