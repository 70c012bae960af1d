#pragma once

#include "scene/scene.h"

namespace rasterwalk {

/// A dense mesh for measurements: a bumpy tube along a torus knot, made from formulas. Its
/// triangles share their corners, cover a few pixels each, and together close a surface. Normals
/// are averaged, so light changes smoothly across the edges.
inline constexpr int knot_triangles = 200'000;
Scene knot_scene();

} // namespace rasterwalk
