#pragma once

// Clip: which part of a polygon lies in the view.
//
// In:  the corners of a polygon in clip space.
// Out: the corners of what is left of it, any number of them; or why nothing is.
// Picture: planes cut off what lies outside, one after the other; each can take a corner away and
//          put two new ones in its place.
//
// The lab clips nothing. What reaches beside the picture is drawn up to its border, pixel by pixel;
// a polygon with a vertex on or behind the camera plane is left out whole, since project() has no
// pixel for it.
//
// Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17(1),
// 1974; in clip space: Blinn and Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.

#include <vector>

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// What clipping does to a polygon.
struct Clipped {
    Rejection rejection = Rejection::none; ///< why it is not drawn, or none
    bool is_cut = false;                   ///< its corners are no longer those that were given
};

/// Every polygon stays as it is.
/// @param corners at least three, in order; they are replaced by those of what is left
inline Clipped clip_nothing(std::vector<ClipVertex>& corners, const VertexRules& rules) {
    static_cast<void>(corners);
    static_cast<void>(rules);
    return {};
}

} // namespace rasterwalk
