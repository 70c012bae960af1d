#pragma once

// Tessellation: each triangle of a mesh is cut into smaller ones of the same shape, before anything
// else is done with it. The surface does not change; it gets more vertices at which light can be
// computed.
//
// In:  a scene, and the number of equal parts into which each edge is cut: n.
// Out: the same scene with n * n triangles in place of each.
// Picture: lines parallel to the three sides, n parts per side.
//
// The classic mistakes: a shared edge cut by each neighbour in its own direction, so that their
// vertices differ by a rounding error and a crack opens; normals mixed and left too short.
//
// Source: B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM
// 18(6), 1975, on light that depends on the polygons and not on the surface; the cut into equal
// parts is the `triangles` domain with `equal_spacing` of the OpenGL 4.6 specification, 11.2.2.

#include "scene/scene.h"

namespace rasterwalk {

/// The number of parts into which the edges of this scene are cut: `wanted`, 1 or more, or as many
/// as most_tessellated_triangles allows. 1, uncut, for a scene in pixels, whose corners are
/// projected already.
int tessellation_of(const Scene& scene, int wanted);

/// The scene with every edge cut into `parts` equal parts, 1 or more. Triangle t becomes the
/// triangles t * parts * parts and following: row by row from its corner 0, each turned as it is.
/// The vertices of the mesh keep their numbers. A new one is mixed from those of its triangle, in
/// equal steps in the world: its position, colour, texcoord, and normal, which is made unit length.
/// It is in the list once, however many triangles meet at it, and neighbours that share only the
/// positions of an edge get the same new positions on it to the last bit.
Scene tessellate(const Scene& scene, int parts);

} // namespace rasterwalk
