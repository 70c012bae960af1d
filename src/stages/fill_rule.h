#pragma once

// The fill rule: which polygon owns a point exactly on an edge?
//
// In:  the direction of an edge, of a polygon whose corners go round clockwise on the screen.
// Out: whether the points of the edge belong to the polygon.
// Picture: two tiles with a joint between them. Each pixel on the joint must belong to one of the
//          two tiles, and to one only.
//
// By the top-left rule a polygon owns its top edges and its left edges. The left edge of one
// triangle is the right edge of its neighbour, so a shared edge has exactly one owner.
//
// The classic mistakes are using >= for all edges, which draws the joint twice, and > for all,
// which leaves holes in it.
//
// Source: Microsoft, Direct3D 11.3 Functional Specification, section 3.4.2.1, triangle
// rasterization rules: the top-left rule.

#include <cstdint>

namespace rasterwalk {

/// The direction from an edge's first corner to its second, y down, with the inside on the right
/// hand.
struct EdgeDirection {
    std::int64_t dx = 0, dy = 0;

    friend bool operator==(const EdgeDirection&, const EdgeDirection&) = default;
};

/// Every edge owns its points.
constexpr bool owns_inclusive(const EdgeDirection&) {
    return true;
}

/// No edge owns its points.
constexpr bool owns_exclusive(const EdgeDirection&) {
    return false;
}

/// Top edges, which are level and have the inside below, and left edges, which go up.
constexpr bool owns_top_left(const EdgeDirection& edge) {
    const bool is_top = edge.dy == 0 && edge.dx > 0;
    const bool is_left = edge.dy < 0;
    return is_top || is_left;
}

/// The sides on which a polygon can have an edge.
inline constexpr EdgeDirection left_side{0, -1}, right_side{0, 1}, top_side{1, 0},
    bottom_side{-1, 0};

/// Do any edges own their points? If not, no corner lies inside either, even one that only inner
/// edges of a fan meet.
constexpr bool owns_any(bool (*owns)(const EdgeDirection&)) {
    return owns(left_side) || owns(right_side) || owns(top_side) || owns(bottom_side);
}

} // namespace rasterwalk
