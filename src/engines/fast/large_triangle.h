#pragma once

// Large triangles, which the fast engine draws row by row.
//
// Light in closed form: on a flat triangle 1/z is linear on the screen, and so is the vector from
// the lamp to the point that a pixel shows, if it is measured in units of z:
//
//     r / z = (P - L) / z = ray - L / z         since P = z ray
//
// Its length is therefore the root of a quadratic in the column, along a row. With the height h of
// the lamp above the plane, cos = h / r, and the light that arrives is
//
//     P h / (4 pi r^3)  =  P / (4 pi) (1/z h^(1/3) / |r / z|)^3
//
// which takes a reciprocal root and five products per pixel, and no vector at all.

#include <cstdint>
#include <span>
#include <vector>

#include "engines/fast/fast_data.h"
#include "engines/fast/fast_mesh.h"

namespace rasterwalk {

/// Edges, plane of 1/z, and light if it has a closed form: a plain colour, one normal that is
/// perpendicular to the triangle, light at pixels, no highlight.
/// @param numbers    of triangles of the mesh on the screen; those edge on or culled are left out
/// @param joins_two  may two consecutive triangles become one, if the same pixels then have the
///                   same light? Their owners can then no longer be told apart
/// @param large      is emptied first; then the nearest comes first
void set_up_large(std::span<const std::int32_t> numbers, const fast::View& view,
                  const FastMesh& mesh, bool joins_two, std::vector<fast::LargeTriangle>& large);

} // namespace rasterwalk
