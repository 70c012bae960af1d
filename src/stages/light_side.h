#pragma once

// Light side: on which of its two sides a surface is lit.
//
// In:  a point, its normal, and the rays along which the camera sees.
// Out: the factor by which the light multiplies that normal, 1 or -1.
// Picture: a wall of no thickness has two sides. Lit on one, its back is as dark as if the lamp
//          were behind it; lit on both, the side that the camera sees is lit, whichever it is.
//
// The classic mistake is to flip the normal toward the lamp instead of the eye, abs(n . l), so that
// light comes through the wall.
//
// Source: two-sided lighting, The OpenGL Graphics System: A Specification, version 2.1, section
// 2.14.1. There a whole triangle is flipped, depending on which way its corners go round on the
// screen; here each lit point, by its own normal.

#include <glm/geometric.hpp>

#include "stages/cull.h"

namespace rasterwalk {

/// On the side to which the normal points: the lab.
/// @param position_world where the light is worked out
/// @param normal         of the surface there, as the light has it, before a normal map bends it
/// @param rays           of the frame
inline float side_of_normal(const glm::vec3& position_world, const glm::vec3& normal,
                            const SightRays& rays) {
    static_cast<void>(position_world);
    static_cast<void>(normal);
    static_cast<void>(rays);
    return 1.0f;
}

/// On the side that the camera sees: -1 if the normal points along the ray of sight. NaN gives 1.
inline float side_of_eye(const glm::vec3& position_world, const glm::vec3& normal,
                         const SightRays& rays) {
    return glm::dot(normal, sight_ray(position_world, rays)) > 0.0f ? -1.0f : 1.0f;
}

} // namespace rasterwalk
