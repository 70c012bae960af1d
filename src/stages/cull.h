#pragma once

// Cull: is a polygon to be drawn at all?
//
// In:  the corners of a polygon in clip space.
// Out: why it is not drawn, or none.
// Picture: of a closed body one sees only the sides that face the camera; on the screen their
//          corners go round the other way than those of the sides that show their backs.
//
// The lab culls nothing: the walls of its room are seen from inside, and either side is drawn.
//
// The classic mistake is to ask for the angle to the direction in which the camera looks: under
// perspective one also sees sides that look past the camera. What counts is the way from the camera
// to the surface.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 15.4, back-face culling. The area of a polygon in homogeneous coordinates: Olano and
// Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997.

#include <span>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// Every polygon is drawn, whichever side it shows.
/// @param corners what clipping has left, at least three
inline Rejection cull_nothing(std::span<const ClipVertex> corners, const VertexRules& rules) {
    static_cast<void>(corners);
    static_cast<void>(rules);
    return Rejection::none;
}

/// By the normal of the surface: it is a back if the normal of the first corner points the way from
/// the camera to that corner, dot(n, p - C) > 0. In world space.
Rejection cull_by_face_normal(std::span<const ClipVertex> corners, const VertexRules& rules);

/// By the order of the corners on the screen: the front goes round clockwise, y down, which is a
/// positive area. Where a corner lies behind the camera there is no such order, and it is drawn.
Rejection cull_by_screen_area(std::span<const ClipVertex> corners, const VertexRules& rules);

/// By the normals of all corners: it is a back if each of them points away from the camera. A
/// smooth body keeps the faces of its outline.
Rejection cull_by_vertex_normals(std::span<const ClipVertex> corners, const VertexRules& rules);

/// Twice the area of the polygon on the screen in square pixels, times the w of three corners a
/// triangle of its fan; the sign is that of the area where every w is positive.
float screen_area_sign(std::span<const ClipVertex> corners, const VertexRules& rules);

/// dot(n, p - C): positive if the normal at this vertex points away from the camera. Where rays are
/// parallel, under orthographic projection, the way they run stands for p - C; between the two, the
/// mixture of both.
float away_from_camera(const ClipVertex& vertex, const VertexRules& rules);

} // namespace rasterwalk
