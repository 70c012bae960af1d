#pragma once

// Tessellation: each triangle of a mesh cut into smaller ones of the same shape, before anything
// else is done with it. The surface stays where it is; there are more vertices on it at which light
// can be worked out.
//
// In:  a scene, and into how many equal parts each edge is cut: n.
// Out: the same scene with n * n triangles in the place of each.
// Picture: lines parallel to the three sides, n parts a side.
//
// The classic mistakes: a shared edge cut by each neighbour in its own direction, so that their
// vertices differ by a rounding error and a crack opens; normals mixed and left too short.
//
// Source: B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM
// 18(6), 1975, on light that follows from the polygons and not from the surface; the cut in equal
// parts is the `triangles` domain with `equal_spacing` of the OpenGL 4.6 specification, 11.2.2.

#include "scene/scene.h"

namespace rasterwalk {

/// Into how many parts the edges of this scene are cut where `wanted` are asked for, 1 or more: as
/// many as that, or as most_tessellated_triangles allows. 1, uncut, for a scene in pixels, whose
/// corners are projected already.
int tessellation_of(const Scene& scene, int wanted);

/// The scene with every edge cut into `parts` equal parts, 1 or more. Triangle t becomes the
/// triangles t * parts * parts and following: row by row from its corner 0, each turned as it is.
/// The vertices of the mesh keep their numbers. A new one lies between those of its triangle:
/// places, colours and texcoords are mixed, in equal steps in the world; normals too, and made unit
/// length. It stands in the list once, however many triangles meet in it, and neighbours that have
/// only the places of an edge in common have the same places on it to the last bit.
Scene tessellate(const Scene& scene, int parts);

} // namespace rasterwalk
