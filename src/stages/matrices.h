#pragma once

// Matrices: one 4x4 matrix for each step from an object to the window.
//
// In:  a point, and the camera, the projection and the size of the picture.
// Out: its position in every space on the way.
// Picture: a chain of boxes, read from the right:
//
//     window = Ts . (division by w) . Tp . Tv . Tm . p
//
//     Tm  model        object -> world     where the object is, see scene/model.h
//     Tv  view         world  -> camera    the world moved and turned in front of the camera
//     Tp  projection   camera -> clip      the view volume, a box once it is divided by w
//     Ts  viewport     ndc    -> window    the box -1..1 spread over the pixels
//
// A 3x3 matrix cannot move: it leaves the origin where it is. A fourth coordinate w = 1 gives the
// movement something to be multiplied with; with w = 0 the same matrix transforms a direction,
// which is turned but not moved.
//
// The lab's line p = (v - C) R is Tv; its f x/z is Tp and the division; its + W/2 is Ts. The same
// numbers come out. They are computed in double here, since a product of matrices rounds in
// different places from the lab. Each matrix is rounded once, at its end; the lab rounds each step
// to float. So a vertex within rounding error of a border between two pixels can end up on the
// other side of it. No vertex of the room does.
//
// The lab truncates f x/z before adding W/2, so the same is done after the chain: only the scale of
// Ts is applied in clip space, where it has the same effect as after the division, and the shift by
// W/2 follows the truncation, in project(). The clip space of this program therefore counts pixels.
//
// The classic mistakes are T R for R T, which walks round the room instead of turning the head; the
// translation in the bottom row, where it spoils w and moves nothing; and w = 1 for a normal.
//
// Vectors are columns here, M p, as in most books and in glm. With rows, as in the lab, every
// matrix is transposed and the order of the product is reversed.
//
// Source: Akenine-Moeller, Haines, Hoffman, Real-Time Rendering, 4th edition, chapter 4,
// transforms; Hughes and others, Computer Graphics: Principles and Practice, 3rd edition, chapter
// 13, camera specifications and transformations; Shirley, Marschner, Fundamentals of Computer
// Graphics, 4th edition, chapter 7, viewing.

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// Tv, from the world to camera space: x right, y down, z forward. Its rows are the camera's right,
/// down and forward axes, after the translation by minus its position.
/// @param rotation R of the camera, see camera_rotation()
glm::dmat4 view_matrix(const glm::dvec3& eye, const glm::dmat3& rotation);

/// Tp, from camera space to clip space: divided by w, x and y go from -1 to 1 over the picture, and
/// z from 0 at the near plane to 1 at the far one. Perspective, orthographic or in between, by
/// rules.projection.mix. With rules.projection.box it is the matrix of glFrustum and glOrtho,
/// except for the signs of y and z and the range of z, which there begins at -1.
glm::dmat4 projection_matrix(const VertexRules& rules);

/// Ndc z of a point at this depth in front of the camera: 0 at the near plane, 1 at the far one.
/// Under perspective f/(f - n) (1 - n/z): half of the range is used up at about twice the near
/// distance.
double ndc_depth(double z, const VertexRules& rules);

/// Ts, from NDC to the window in pixels: x_window = x_ndc W/2 + W/2 with the lab's whole W/2, and
/// the same for y, because both run down.
glm::dmat4 viewport_matrix(const VertexRules& rules);

/// In the slot vertex_shader: the same as vertex_shader(), through Tv, Tp and the scale of Ts.
ClipVertex vertex_shader_by_matrices(const Vertex& vertex, const glm::mat3& rotation,
                                     const VertexRules& rules, const Stages& stages,
                                     VertexSpaces* spaces);

} // namespace rasterwalk
