#pragma once

// A mistake in a slot of stages/shadow.h. The other two of shadows, no bias and too much of it, are
// values of settings.

#include <limits>

#include "stages/shadow.h"

namespace rasterwalk {

/// B60, in the slot shadow_ray: the ray is not ended at the lamp. What stands behind the lamp, seen
/// from the point, casts a shadow as well.
inline WorldRay shadow_ray_past_lamp(const ShadowPoint& point, float offset) {
    WorldRay ray = shadow_ray(point, offset);
    ray.end = std::numeric_limits<float>::infinity();
    return ray;
}

} // namespace rasterwalk
