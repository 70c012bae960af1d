#pragma once

// The triangles of the scene in the world, and their colours seen from outside.

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "scene/scene.h"

namespace rasterwalk {

/// What every view needs of every triangle.
struct WorldTriangle {
    glm::vec3 corner{0.0f}; ///< the first
    glm::vec3 normal{0.0f}; ///< into the room and out of the blocks; not of unit length
    glm::vec3 colour{0.0f}; ///< the mean of its vertices, shaded, so that neighbouring sides differ
    float extent = 0.0f;    ///< the longest side of the box around it, world units
};

/// All triangles of the scene, in its order.
std::vector<WorldTriangle> world_triangles(const Scene& scene);

/// Is this a wall that the eye would see from the back, and the camera from the front? Such a wall
/// is between the eye and the room.
bool is_culled(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& camera);

/// The mean colour of its vertices, without light.
glm::vec3 own_colour(const Scene& scene, int triangle);

/// The corners of a triangle of the scene in the space of the eye.
std::array<glm::dvec3, triangle_corners> eye_corners(const Scene& scene, int triangle,
                                                     const OutsideEye& eye);

} // namespace rasterwalk
