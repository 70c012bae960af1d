#pragma once

// A triangle of the scene as it stands in the world, and how it is coloured from outside.

#include <array>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

struct WorldTriangle {
    std::array<glm::dvec3, triangle_corners> corners;
    glm::dvec3 normal{0.0}; ///< into the room and out of the blocks; not of unit length
};

/// @param triangle of the scene; must be one
WorldTriangle world_triangle(const Scene& scene, int triangle);

/// Is this a wall that the eye would see from its back, and the camera from its front? It stands
/// between the eye and the room.
bool is_culled(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& camera);

/// The mean colour of its vertices, without light.
glm::vec3 own_colour(const Scene& scene, int triangle);

/// Lighter or darker by where it faces, so that neighbouring sides are told apart, 0..1.
float shade_of(const WorldTriangle& triangle);

} // namespace rasterwalk
