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
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 15.4, back-face culling.

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

} // namespace rasterwalk
