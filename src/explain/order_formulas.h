#pragma once

// Why a triangle has its place in the drawn list: the depth that it was sorted by, or on which side
// of each plane above it in the BSP tree the camera is.

#include <string_view>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// A node on the way from the root of the BSP tree to a triangle.
struct OrderNode {
    int node = 0;
    int triangle = 0;      ///< of the scene, whose plane it is
    bool is_front = false; ///< the triangle lies on the side that the normal points to
    bool is_near = false;  ///< and that is the side on which the camera is
    bool is_last = false;  ///< and that side is drawn last: the same, but for a mistake
};

/// The nodes above the triangle's own, the root first; none unless a BSP tree gave it its place.
std::vector<OrderNode> order_nodes(const Frame& frame, int triangle);

/// The formulas, all in section "order": `order.depth`, or `order.side.N` for each node N above the
/// triangle's own, the root first, and for that one. None if the frame has no list.
std::vector<Formula> order_formulas(const Frame& frame, int triangle);

/// Is this the id of such a formula, for some scene and settings?
bool is_order_formula(std::string_view id);

} // namespace rasterwalk
