#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// A rectangle of samples outside of which nothing of a convex polygon is seen: the smallest, or
/// one a little larger; all of the area if a part of the polygon is too near. Empty if nothing of
/// it is seen, or a corner is not finite.
/// @param eye     in samples
/// @param corners in the space of the eye
/// @param area    the samples that are asked for
Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area);

} // namespace rasterwalk
