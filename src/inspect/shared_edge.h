#pragma once

// Two triangles that share an edge, and what each fill rule does with the pixels whose centres lie
// on that edge: drawn by both, by one, or by none (stages/fill_rule.h). A pixel with several
// samples is drawn by both only where both cover the same sample.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/frame.h"
#include "settings/choices.h"
#include "stages/rectangle.h"
#include "stages/snap.h"

namespace rasterwalk {

/// The rules that are compared; the others are faulty versions of them.
inline constexpr std::array compared_fill_rules{FillRule::inclusive, FillRule::exclusive,
                                                FillRule::top_left};

/// An edge that two triangles of the frame share. They lie on opposite sides of it.
struct SharedEdge {
    int triangle = 0, edge = 0;            ///< edge i goes from corner i to the next
    int neighbour = 0, neighbour_edge = 0; ///< the other triangle, and the same edge as its own

    friend bool operator==(const SharedEdge&, const SharedEdge&) = default;
};

/// The edges that a triangle shares, each with the first neighbour in drawing order. None if
/// coverage walks edges and uses no fill rule; none for triangles that are cut or not drawn. Looks
/// through all triangles of the frame.
std::vector<SharedEdge> shared_edges(const Frame& frame, int triangle);

/// A shared edge under one rule. Pixels are drawn by the function that covers the frame's
/// triangles; all count, even those outside the picture.
struct EdgeByRule {
    FillRule rule = FillRule::inclusive;
    std::int64_t twice = 0; ///< pixels that both triangles draw
    std::int64_t holes = 0; ///< pixels whose centres lie on the edge between its ends, but that
                            ///< neither draws, not even a sample of them

    friend bool operator==(const EdgeByRule&, const EdgeByRule&) = default;
};
using EdgeByRules = std::array<EdgeByRule, compared_fill_rules.size()>;

/// The same edge by each of compared_fill_rules.
EdgeByRules count_by_rules(const Frame& frame, const SharedEdge& shared);

/// The shared edge of a triangle to show: the nearest to a pixel, or without one the edge on which
/// most pixels are drawn twice when all triangles keep them; the first if several are equal.
std::optional<SharedEdge> shared_edge_at(const Frame& frame, int triangle,
                                         const std::optional<glm::ivec2>& pixel);

/// Who draws a pixel next to a shared edge. Of a pixel with samples of both, none of them in
/// common, the one that covers more.
enum class EdgePixel : std::uint8_t { neither, triangle, neighbour, twice, hole };

/// A shared edge and the pixels around it, by each of compared_fill_rules.
struct EdgePicture {
    SharedEdge shared;
    EdgeByRules rules; ///< counted along the whole edge, not only in the window
    Rectangle window;  ///< pixels of the picture
    std::array<std::vector<EdgePixel>, compared_fill_rules.size()>
        pixels; ///< of the window, row by row, by each rule
    std::array<std::array<GridPoint, triangle_corners>, 2>
        outlines; ///< the snapped corners of the triangle and of its neighbour
};

EdgePicture edge_picture(const Frame& frame, const SharedEdge& shared, const Rectangle& window);

/// The window for the picture has at most this many columns and rows.
inline constexpr int edge_window_side = 12;

/// A window with both whole triangles, if there is room; or else with the part of the edge nearest
/// to a pixel, or its middle. The edge is divided into parts, so that pixels next to each other
/// mostly have the same window.
Rectangle edge_window(const Frame& frame, const SharedEdge& shared,
                      const std::optional<glm::ivec2>& pixel);

} // namespace rasterwalk
