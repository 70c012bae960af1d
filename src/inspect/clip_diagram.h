#pragma once

// What one plane does in clip space, as a plot of two coordinates: w upward, and to the side the
// one that the plane asks. There the plane is a straight line, also where w is negative, and each
// edge meets it once at most: that is why one cuts before the division.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "inspect/cut_corners.h"
#include "inspect/row_graph.h"

namespace rasterwalk {

/// A place of the plot is (the coordinate to the side, w), of clip space.
struct ClipDiagram {
    ClipPlane plane = ClipPlane::near;
    int side = 0; ///< the coordinate to the side: 0 x, 1 y, 2 z

    std::vector<CutCorner> corners; ///< of the polygon before the plane
    std::vector<ClipStep> steps;    ///< one for each of its edges
    std::vector<CutCorner> made;    ///< the corners that the plane makes, in the order of the steps

    /// A corner is no number, or too far away: then all below is empty.
    bool is_endless = false;

    Interval side_range, w_range;   ///< what is shown: all corners, and some room around them
    std::vector<glm::dvec2> inside; ///< what of that lies on the inner side: a convex polygon
    /// Where the plane runs through it; none where it lies beside it.
    std::optional<std::array<glm::dvec2, 2>> line;

    glm::dvec2 place(const CutCorner& corner) const {
        return {corner.vertex.position_clip[side], corner.vertex.position_clip.w};
    }
};

/// The diagram of a plane that is asked; none where no polygon comes to it. To the side stands the
/// coordinate in which the plane is written: x for left and right, y for top and bottom, z for near
/// and far. Where z is the same at all corners, as the 1 that the lab's depth is divided from, the
/// plane is a line at one w, and the wider one of x and y stands there.
std::optional<ClipDiagram> clip_diagram(const ClipHistory& history, ClipPlane plane);

/// What holds on the inner side, in the coordinates of the plot: "x + 100 · w ≥ 0", "w − 0.1 ≥ 0".
std::string inside_condition(const ClipHistory& history, const ClipDiagram& diagram);

} // namespace rasterwalk
