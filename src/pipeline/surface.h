#pragma once

#include "pipeline/frame.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

/// What all fragments of a triangle have in common, for the frame's pixel shader. Parts that only
/// surfaces beyond the lab's need are worked out only for them.
Surface surface_of(const Frame& frame, int triangle);

/// The same with everything that light per pixel needs, whatever shader is used.
Surface lit_surface_of(const Frame& frame, int triangle);

/// The normal of a whole triangle: the one its corners share, or the one worked out from their
/// positions.
glm::vec3 triangle_normal(const Scene& scene, int triangle);

/// The same as the light has it.
glm::vec3 flat_normal(const Frame& frame, int triangle);

/// Where flat shading works out the light of a triangle, whatever shading is used; its normal is on
/// the side that is lit.
SurfacePoint flat_point(const Frame& frame, int triangle);

} // namespace rasterwalk
