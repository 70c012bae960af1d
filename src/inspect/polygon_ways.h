#pragma once

// A polygon of a scene, covered in three ways: what a row table and a fan of triangles make of it,
// beside the pixels that lie inside. Without dents all three are the same.

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/frame.h"

namespace rasterwalk {

/// Pixels are asked at their centres, by the frame's snap and fill rule; all count, also those that
/// lie beside the picture.
struct PolygonWays {
    int corners = 0;           ///< of its outline
    std::int64_t inside = 0;   ///< pixels inside, by the list of active edges
    std::int64_t table = 0;    ///< from the first to the last of them in every row: a row table
    int rows = 0;              ///< that have pixels inside
    int wrong_rows = 0;        ///< of them, in which the row table has others too
    std::int64_t fan = 0;      ///< pixels that a triangle of the fan covers
    std::int64_t fan_laid = 0; ///< the same, each as often as triangles cover it
    double area = 0.0;         ///< of the outline, square pixels; never negative
    double fan_area = 0.0;     ///< of all triangles of the fan together
};

/// The corners of the polygon to which a triangle of the frame belongs, where they are drawn; none
/// if it belongs to none, or if one of its triangles is cut, is left out, or was moved alone.
std::vector<ScreenVertex> outline_of(const Frame& frame, int triangle);

/// The same polygon in numbers; none where there is no outline.
std::optional<PolygonWays> polygon_ways(const Frame& frame, int triangle);

} // namespace rasterwalk
