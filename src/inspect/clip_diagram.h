#pragma once

// What one plane does in clip space, as a plot of two coordinates: w upward, and to the side the
// one that the plane tests. There the plane is a straight line, even where w is negative, and each
// edge meets it once at most: that is why clipping comes before the division.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "inspect/cut_corners.h"
#include "inspect/row_graph.h"

namespace rasterwalk {

/// A point in the plot is (the coordinate to the side, w), in clip space.
struct ClipDiagram {
    ClipPlane plane = ClipPlane::near;
    int side = 0; ///< the coordinate to the side: 0 x, 1 y, 2 z

    std::vector<CutCorner> corners; ///< of the polygon before the plane
    std::vector<ClipStep> steps;    ///< one for each of its edges
    std::vector<CutCorner> made;    ///< the corners that the plane makes, in the order of the steps

    /// A corner is NaN, or too far away: then everything below is empty.
    bool is_endless = false;

    Interval side_range, w_range;   ///< what is shown: all corners, with a margin
    std::vector<glm::dvec2> inside; ///< the part of that on the inner side: a convex polygon
    /// Where the plane runs through it; none if it passes outside.
    std::optional<std::array<glm::dvec2, 2>> line;

    glm::dvec2 place(const CutCorner& corner) const {
        return {corner.vertex.position_clip[side], corner.vertex.position_clip.w};
    }
};

/// The diagram of a plane that clips; none if no polygon reaches it. To the side goes the
/// coordinate that the plane is written in: x for left and right, y for top and bottom, z for near
/// and far. If z is the same at all corners, like the 1 from which the lab's 1/z comes, the
/// plane is a line at one w, and the wider of x and y goes there.
std::optional<ClipDiagram> clip_diagram(const ClipHistory& history, ClipPlane plane);

/// The condition for the inner side, in the coordinates of the plot:
/// "x + 100 · w ≥ 0", "w − 0.1 ≥ 0".
std::string inside_condition(const ClipHistory& history, const ClipDiagram& diagram);

} // namespace rasterwalk
