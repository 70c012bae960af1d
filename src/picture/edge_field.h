#pragma once

// The edge function of one edge as a field over the whole picture: where it is positive, negative
// and 0, and the lines of equal E.
//
// Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", Computer Graphics 22(4),
// SIGGRAPH 1988.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/frame.h"
#include "stages/edge_functions.h"

namespace rasterwalk {

/// The edge function of an edge of a drawn triangle, between the places that coverage gives its
/// vertices, whether coverage asks for it or not.
struct EdgeField {
    int triangle = 0;
    EdgeFunction edge; ///< of the polygon that is drawn; positive on the inner side
    /// |E| at a pixel's centre in the picture, 65536ths of a square pixel.
    std::int64_t largest = 0;

    /// E at the centre of a pixel, 65536ths of a square pixel.
    std::int64_t at(int column, int row) const {
        return edge.at({pixel_centre(column), pixel_centre(row)});
    }

    friend bool operator==(const EdgeField&, const EdgeField&) = default;
};

/// The field of an edge of a drawn triangle; an edge that the polygon does not have is its last.
/// None if the polygon has no area: then no side is the inner one.
std::optional<EdgeField> edge_field(const Frame& frame, int triangle, int edge);

/// A line of equal E through the picture.
struct FieldLine {
    double e = 0.0;                ///< square pixels
    glm::dvec2 from{0.0}, to{0.0}; ///< pixels from the picture's upper left corner
};

/// The lines in a part of the picture on which E is a multiple of `step`, the smallest E first.
/// @param low, high of the part, pixels from the picture's upper left corner
/// @param step above 0, square pixels
std::vector<FieldLine> field_lines(const EdgeField& field, glm::dvec2 low, glm::dvec2 high,
                                   double step);

/// The smallest of 1, 2, 5, 10, 20, 50 ... square pixels whose lines are at least so many pixels
/// apart; 0 if the edge has no length.
double field_step(const EdgeField& field, double least_distance);

/// At most so many lines are returned.
inline constexpr int most_field_lines = 200;

} // namespace rasterwalk
