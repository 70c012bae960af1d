#pragma once

// The weights of a pixel as areas: its centre, joined with the vertices, makes three triangles, and
// each one's share of the whole is the weight of the vertex opposite.
//
// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", Computer Graphics 22(4),
// SIGGRAPH 1988; A. F. Möbius, "Der barycentrische Calcul", Leipzig, 1827.

#include <array>
#include <optional>

#include <glm/vec2.hpp>

#include "pipeline/frame.h"
#include "stages/edge_functions.h"

namespace rasterwalk {

/// The triangle that an edge makes with the pixel's centre.
struct WeightPart {
    GridPoint from, to;  ///< the edge
    int edge = 0;        ///< of the polygon that is drawn; -1: an inner one of its fan
    int vertex = 0;      ///< the corner opposite, of the polygon
    float weight = 0.0f; ///< of that corner, by the frame's own function; below 0 beyond the edge

    friend bool operator==(const WeightPart&, const WeightPart&) = default;
};

struct WeightParts {
    int triangle = 0;
    glm::ivec2 pixel{0};
    GridPoint centre;
    std::array<WeightPart, edge_function_count> parts;

    friend bool operator==(const WeightParts&, const WeightParts&) = default;
};

/// The parts of a pixel in a drawn triangle; in a polygon, in the triangle of its fan that the
/// pixel belongs to. None if that has no area.
std::optional<WeightParts> weight_parts(const Frame& frame, int triangle, glm::ivec2 pixel);

} // namespace rasterwalk
