#pragma once

// A mistake in a slot of stages/shadow.h. The other two mistakes with shadows, no bias and too much
// of it, are values of settings.

#include <limits>

#include "stages/shadow.h"

namespace rasterwalk {

/// B60, in the slot shadow_ray: the ray does not end at the lamp. Things behind the lamp, seen from
/// the point, cast shadows as well.
inline WorldRay shadow_ray_past_lamp(const ShadowPoint& point, float offset) {
    WorldRay ray = shadow_ray(point, offset);
    ray.end = std::numeric_limits<float>::infinity();
    return ray;
}

} // namespace rasterwalk
