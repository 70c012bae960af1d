#pragma once

// Reject: does a polygon lie entirely outside?
//
// In:  the corners of a polygon in clip space.
// Out: why it is not drawn, or none.
// Picture: every corner gets one bit for each plane of the view volume, 1 if it lies beyond. A bit
//          that all corners have in common names a plane beyond which the whole polygon lies:
//          reject it. No bit anywhere: it lies inside, accept it. Otherwise it may have to be cut.
//
// No common bit does not mean that a part is inside: a triangle can pass by a corner of the view.
// Clipping then leaves nothing of it.
//
// "Cheap clipping" cuts nothing at all: it rejects by the codes, and walks the rows of the other
// polygons only as far as the picture reaches, see walk_in_picture().
//
// Source: the codes are those of D. Cohen and I. Sutherland for lines: Newman and Sproull,
// Principles of Interactive Computer Graphics, 1973.

#include <cstdint>
#include <span>

#include "stages/clip.h"

namespace rasterwalk {

/// One bit for each plane: bit i is for ClipPlane i.
using Outcode = std::uint8_t;

/// The planes beyond which a vertex lies.
Outcode outcode(const ClipVertex& vertex, const ClipPlanes& planes);

/// Every polygon goes on.
/// @param corners at least three
inline Rejection reject_nothing(std::span<const ClipVertex> corners, const ViewVolume& volume) {
    static_cast<void>(corners);
    static_cast<void>(volume);
    return Rejection::none;
}

/// By the codes: outside if all corners lie beyond the same outer plane, so nothing visible is
/// rejected. In pixel space nothing is rejected.
Rejection reject_by_outcodes(std::span<const ClipVertex> corners, const ViewVolume& volume);

} // namespace rasterwalk
