#pragma once

// Where a triangle of the scene is, and which side of it is seen: the questions of reject, clip and
// cull.

#include <optional>

#include "inspect/clip_history.h"
#include "stages/polygon_corners.h"

namespace rasterwalk {

/// What is worked out in advance about a triangle.
struct TriangleSides {
    /// By outer_planes(), as in reject_by_outcodes(); no planes in pixel space.
    TriangleCodes codes;
    /// away_from_camera() of as_one_face(): positive if it faces away. World units.
    float away = 0.0f;
    /// t of its first edge that the near plane cuts, 0 at the corner in front of the plane: from
    /// the function that clips, or the right one if that cuts nothing. None if no edge is cut.
    std::optional<float> near_t;
};

/// Uses the vertices of the scene, before they are clipped.
TriangleSides triangle_sides(const Frame& frame, int triangle);

/// The two arrows of a triangle on the screen, from its first corner to the other two, in whole
/// pixels, x right and y down.
struct ArrowProducts {
    double dot = 0.0;   ///< of both
    double cross = 0.0; ///< u.x v.y - u.y v.x: twice the area, positive if the corners go round
                        ///< clockwise, which is the front
    double base = 0.0;  ///< length of the first, in pixels
};

/// None for a polygon that clipping has left with more or fewer than three corners.
std::optional<ArrowProducts> arrows_of(PolygonCorners corners);

} // namespace rasterwalk
