#pragma once

// Mistakes in the slot of stages/cull.h.

#include "stages/cull.h"

namespace rasterwalk {

/// B34, in the slot cull: by the angle to the direction in which the camera looks,
/// dot(n, forward) > 0. Under perspective some visible sides are culled, and some hidden ones kept.
Rejection cull_by_view_axis(std::span<const ClipVertex> corners, const VertexRules& rules,
                            const SightRays& rays, CullTest* test = nullptr);

/// B81, in the slot cull: by the side from which the light falls, dot(n, p - L) > 0 with the lamp L
/// in place of the camera. In pixel space, where there is no lamp, nothing is culled.
Rejection cull_by_lamp(std::span<const ClipVertex> corners, const VertexRules& rules,
                       const SightRays& rays, CullTest* test = nullptr);

} // namespace rasterwalk
