#pragma once

// Project: from clip space to a pixel.
//
// In:  a vertex in clip space, the size of the picture.
// Out: column and row, 1/z, and the varyings as rows carry them; or why the vertex has no pixel.
// Picture: divide by w, which is the distance from the camera, so that what is far becomes small;
//          shift to the middle of the picture (the viewport transform); round to a whole pixel.
//
// The classic mistakes: a vertex behind the camera (dividing by a negative z mirrors it), and int()
// on a negative coordinate, which rounds toward the middle of the picture and leaves the left
// column and the top row black.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 6.5; Blinn, Jim Blinn's Corner: A Trip Down the Graphics Pipeline, on the homogeneous
// division.

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// What project() makes of a vertex.
struct ProjectedVertex {
    Fragment pixel;                        ///< valid if has_pixel
    Rejection rejection = Rejection::none; ///< why its triangles are not drawn
    bool has_pixel = false;                ///< a vertex can be rejected though it has one
};

/// Perspective division, viewport transform and snap to a whole pixel. `stages` is the table whose
/// function weighs the varyings.
/// @param spaces receives the place before rounding, or null
ProjectedVertex project(const ClipVertex& vertex, const VertexRules& rules, const Stages& stages,
                        VertexSpaces* spaces);

/// A vertex through all its spaces, for reports.
struct ShadedVertex {
    VertexSpaces spaces;
    Fragment pixel;                        ///< valid if has_pixel
    Rejection rejection = Rejection::none; ///< why its triangles are not drawn
    bool has_pixel = false;

    glm::vec3 in(std::string_view space) const { return spaces.in(space); }
};

/// Vertex shader and projection by the functions of the table, with every space on the way.
ShadedVertex shade_vertex(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                          const Stages& stages);

} // namespace rasterwalk
