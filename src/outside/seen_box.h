#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "outside/outside_eye.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// A rectangle of samples that contains all that is seen of a convex polygon: the smallest, or a
/// slightly larger one; the whole area if a part of the polygon is too near. Empty if nothing of
/// it is seen, or a corner is not finite.
/// @param eye     in samples
/// @param corners in the space of the eye
/// @param area    the samples of interest
Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area);

} // namespace rasterwalk
