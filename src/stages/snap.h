#pragma once

// Snap: the grid points at which a polygon's corners are when its pixels are found.
//
// In:  a vertex on the screen: its unrounded position, and the whole pixel that it falls in.
// Out: a point in whole 256ths of a pixel.
// Picture: graph paper. Between its lines there is nothing, so every later computation can be done
//          in whole numbers, and two triangles that share an edge agree about it to the bit.
//
// The lab snaps to whole pixels: walls jump by a pixel when the camera moves slowly. Hardware keeps
// 8 bits of the fraction.
//
// The classic mistake is to keep the floats: whether a point lies on an edge then depends on the
// corner at which the computation begins.
//
// Source: Microsoft, Direct3D 11.3 Functional Specification, section 3.4.1, coordinates snapped to
// fixed point with 8 bits of fraction.

#include <cstdint>
#include <span>
#include <vector>

#include "stages/polygon_corners.h"
#include "stages/rectangle.h"
#include "stages/screen_vertex.h"

namespace rasterwalk {

struct EdgeRules;
struct Stages;

/// Parts of a pixel on the grid, along each axis.
inline constexpr std::int64_t grid_parts = 256;

/// A point on the grid: 256ths of a pixel from the left and from the top of the picture.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// Where a pixel is tested for coverage: half a pixel to the right of its left side and below its
/// top.
constexpr std::int64_t pixel_centre(int column_or_row) {
    return grid_parts * column_or_row + grid_parts / 2;
}

/// Twice the area of three points; positive where they go round clockwise on the screen.
constexpr std::int64_t double_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The column or row in which a coordinate lies; a border belongs to the pixel after it.
int pixel_at(std::int64_t coordinate);

/// At the centre of the whole pixel that the vertex was rounded to.
GridPoint snap_to_centre(const ScreenVertex& vertex);

/// To the nearest 16th of a pixel, halves to the right and downward.
GridPoint snap_to_sixteenth(const ScreenVertex& vertex);

/// To the nearest 256th of a pixel, in the same way.
GridPoint snap_to_subpixel(const ScreenVertex& vertex);

/// Where the corners of a polygon are, by the slot `snap`.
/// @param points receives them, replacing its contents
/// @param sample where pixels are tested, from their centres: the corners are moved the other way,
///               so that those who test centres find the pixels whose samples lie inside
void snap_corners(PolygonCorners vertices, const Stages& stages, std::vector<GridPoint>& points,
                  const GridPoint& sample = {});

/// All pixels that the box of these points touches.
/// @param points at least one
Rectangle touched_pixels(std::span<const GridPoint> points);

/// All pixels that the box of the snapped corners touches: the slot polygon_box for coverage that
/// starts from the grid.
Rectangle snapped_box(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages);

} // namespace rasterwalk
