#pragma once

// Mistakes in the slots of stages/project.h.

#include "stages/project.h"

namespace rasterwalk {

/// B13, in the slot is_in_front: no check whether a vertex lies in front of the camera; division by
/// a negative z mirrors it. Vertices that land too far out are still left out.
inline bool is_in_front_unasked(const glm::vec4& clip, const VertexRules& rules) {
    static_cast<void>(clip);
    static_cast<void>(rules);
    return true;
}

/// B14, in the slot project: a vertex behind the camera is marked by the column -1, so any vertex
/// with the column -1 is taken to be behind the camera.
ProjectedVertex project_marking_column(const ClipVertex& vertex, const VertexRules& rules,
                                       const Stages& stages, VertexSpaces* spaces);

/// B74, in the slot viewport_middle: half of the picture's size is not added, so its middle is in
/// the upper left corner.
inline glm::ivec2 middle_in_corner(const VertexRules& rules) {
    static_cast<void>(rules);
    return {0, 0};
}

/// B15, in the slot snap_to_pixel: a vertex outside the picture is moved to its border, which bends
/// the edges that end in it. No position stays beyond the centres of the pixels at the border.
ScreenPlace snap_into_picture(const glm::vec2& projected, glm::ivec2 middle,
                              const VertexRules& rules);

} // namespace rasterwalk
