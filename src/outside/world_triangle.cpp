#include "outside/world_triangle.h"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// The smallest share of its colour that a side turned away from the light has.
constexpr double shaded = 0.72;

const glm::dvec3 light_direction(0.36, -0.80, -0.48);

} // namespace

WorldTriangle world_triangle(const Scene& scene, int triangle) {
    WorldTriangle world;
    for (int i = 0; i < triangle_corners; ++i)
        world.corners[static_cast<std::size_t>(i)] = scene.corner(triangle, i).position;
    const auto& [a, b, c] = world.corners;
    world.normal = glm::cross(c - a, b - a);
    return world;
}

bool is_culled(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& camera) {
    const glm::dvec3& corner = triangle.corners[0];
    return glm::dot(triangle.normal, eye - corner) <= 0.0 &&
           glm::dot(triangle.normal, camera - corner) > 0.0;
}

glm::vec3 own_colour(const Scene& scene, int triangle) {
    glm::vec3 sum(0.0f);
    for (int i = 0; i < triangle_corners; ++i)
        sum += scene.corner(triangle, i).reflectance;
    return sum / static_cast<float>(triangle_corners);
}

float shade_of(const WorldTriangle& triangle) {
    const double length = glm::length(triangle.normal);
    if (!(length > 0.0)) return 1.0f;
    const double cosine = std::abs(glm::dot(triangle.normal, light_direction)) / length;
    return static_cast<float>(shaded + (1.0 - shaded) * cosine);
}

} // namespace rasterwalk
