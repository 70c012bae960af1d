#pragma once

// What a whole picture shows, by a ray through the centre of every pixel, in double precision. Like
// ray_caster.h it shares no code with the stages: each ray is checked against the ends of the view
// volume, and only the outlines are worked out on the screen.

#include <vector>

#include "scene/scene.h"

namespace rasterwalk::test {

/// Depths in front of the camera between which something is seen, world units.
struct DepthRange {
    double near = 0.0, far = 0.0; ///< 0 < near < far
};

/// What a pixel gets instead of a triangle.
inline constexpr int ray_meets_nothing = -1, ray_near_outline = -2;

/// Casts the rays. The camera may be anywhere.
/// @param margin pixels whose centres lie no farther from an outline of any triangle, hidden ones
///               too, get ray_near_outline. Where a triangle is cut by one of the two depths, its
///               outline runs along the cut
/// @return for each pixel, row by row, the triangle that is met first
std::vector<int> cast_rays(const Scene& scene, const Camera& camera, Viewport size,
                           DepthRange depths, double margin);

} // namespace rasterwalk::test
