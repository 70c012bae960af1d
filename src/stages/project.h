#pragma once

// Project: from clip space to a pixel.
//
// In:  a vertex in clip space, the size of the picture.
// Out: column and row, 1/z, and the varyings as rows carry them; or why the vertex has no pixel.
// Picture: divide by w, the depth in front of the camera, so that far things become small; shift to
//          the middle of the picture (the viewport transform); round to a whole pixel.
//
// The classic mistakes are a vertex behind the camera (dividing by a negative z mirrors it), and
// int() on a negative coordinate, which rounds toward the middle of the picture and leaves the left
// column and the top row black. A vertex behind the camera has no pixel; a mark that is a possible
// column, such as -1, is sooner or later mistaken for a real one, and moving the vertex to the
// picture's border bends the edges that end in it.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 6.5; Blinn, Jim Blinn's Corner: A Trip Down the Graphics Pipeline, on the homogeneous
// division.

#include <glm/vec2.hpp>

#include "stages/screen_vertex.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// Projected coordinates beyond this many pixels from the picture's middle are not drawn: a vertex
/// just in front of the camera would otherwise make an edge of millions of samples.
inline constexpr float max_pixel_distance = 16384.0f;

/// The result of project() for a vertex.
struct ProjectedVertex {
    ScreenVertex pixel;                    ///< valid if has_pixel
    Rejection rejection = Rejection::none; ///< why its triangles are not drawn
    bool has_pixel = false;                ///< a vertex with a pixel can still be rejected
};

/// Does a vertex lie in front of the camera? One that does not is not divided. Under perspective
/// `w` of clip space is z of camera space. If the projection is orthographic or mixed, w is
/// positive behind the camera too, so z itself is tested. NaN is not in front.
/// @param clip its position in clip space
bool is_in_front(const glm::vec4& clip, const VertexRules& rules);

/// Can it be divided? The only question left once the near plane has cut: a corner on the plane
/// must not be lost because z is recovered from clip space with a rounding error.
inline bool has_positive_w(const glm::vec4& clip, const VertexRules& rules) {
    static_cast<void>(rules);
    return clip.w > 0.0f;
}

/// The perspective division: pixels from the middle of the picture.
inline glm::vec2 perspective_divide(const glm::vec4& clip, float inv_w) {
    return glm::vec2(clip.x, clip.y) * inv_w;
}

/// The viewport transform: where in the picture its middle lies, in whole pixels; in pixel space,
/// places already count from its corner.
glm::ivec2 viewport_middle(const VertexRules& rules);

/// Where a vertex falls in the picture.
struct ScreenPlace {
    glm::vec2 position{0.0f}; ///< not rounded, see ScreenVertex
    glm::ivec2 pixel{0};      ///< column and row
};

/// The snap to whole pixels. The lab rounds first and then moves to the middle, int(f x / z) + W/2;
/// VertexRounding has the other ways.
/// @param projected pixels from the middle
/// @param middle    of the viewport transform
ScreenPlace snap_to_pixel(const glm::vec2& projected, glm::ivec2 middle, const VertexRules& rules);

/// Perspective division, viewport transform and snap to a whole pixel, by the functions of the
/// table, which also gives the varyings their weight.
/// @param spaces receives the place before rounding, or null
ProjectedVertex project(const ClipVertex& vertex, const VertexRules& rules, const Stages& stages,
                        VertexSpaces* spaces);

/// A vertex in all its spaces, for reports.
struct ShadedVertex {
    VertexSpaces spaces;
    glm::vec4 position_clip{0.0f};         ///< see ClipVertex
    ScreenVertex pixel;                    ///< valid if has_pixel
    Rejection rejection = Rejection::none; ///< why its triangles are not drawn
    bool has_pixel = false;

    glm::vec3 in(std::string_view space) const { return spaces.in(space); }
};

/// Vertex shader and projection by the functions of the table, with every space on the way.
ShadedVertex shade_vertex(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                          const Stages& stages);

} // namespace rasterwalk
