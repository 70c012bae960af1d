#pragma once

#include "pipeline/frame.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

/// What is the same for all fragments of a triangle, as the frame's pixel shader takes it. What
/// only surfaces need that the lab does not have is worked out only for them.
Surface surface_of(const Frame& frame, int triangle);

/// The same with all that light worked out at a pixel asks for, whatever shader is in force.
Surface lit_surface_of(const Frame& frame, int triangle);

/// The normal of a whole triangle, as the light has it: the one that its corners share, or the one
/// across their places.
glm::vec3 flat_normal(const Frame& frame, int triangle);

/// Where flat shading works out the light of a triangle, whatever shading is in force; its normal
/// is on the side that is lit.
SurfacePoint flat_point(const Frame& frame, int triangle);

} // namespace rasterwalk
