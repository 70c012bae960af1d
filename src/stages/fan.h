#pragma once

// A polygon as a fan of triangles about its first corner: right if the polygon is convex.
//
// A polygon that clipping has cut is convex before the snap. The snap to whole pixels moves corners
// by up to half a pixel and can bend it inward, where corners lie close together. A triangle of the
// fan then goes round the other way. It is filled like the others, so it sometimes covers a pixel
// at the dent that active_edges.h leaves out.
//
// An inner edge runs between two triangles of the fan. Whatever the fill rule, it follows the
// top-left rule: it must neither leave a hole in the polygon nor be drawn twice.

#include <array>
#include <cstddef>
#include <span>

#include "stages/snap.h"

namespace rasterwalk {

/// Calls the function with the corners of every triangle of the fan, in order, as indices into the
/// polygon: the first corner, and two neighbours.
/// @param count of the polygon's corners
template <class Use>
constexpr void for_each_fan_corners(std::size_t count, Use use) {
    for (std::size_t last = 2; last < count; ++last)
        use(std::size_t{0}, last - 1, last);
}

/// A triangle of the fan. Edge i goes from corner i to the next.
struct FanTriangle {
    std::array<int, 3> corners{};      ///< of the polygon
    std::array<bool, 3> is_inner{};    ///< the edges that are not the polygon's
    std::array<GridPoint, 3> points{}; ///< where the corners are
    std::int64_t area = 0;             ///< twice the area; negative if counterclockwise
};

/// Calls the function with every triangle of the fan, in order, including those without area.
/// @param points where the polygon's corners are
template <class Use>
void for_each_fan_triangle(std::span<const GridPoint> points, Use use) {
    const int count = static_cast<int>(points.size());
    const auto triangle_to = [&](int last) {
        FanTriangle triangle{{0, last - 1, last}};
        for (std::size_t i = 0; i < 3; ++i)
            triangle.points[i] = points[static_cast<std::size_t>(triangle.corners[i])];
        triangle.area = double_area(triangle.points[0], triangle.points[1], triangle.points[2]);
        return triangle;
    };
    // If the first corners lie on a line, the outline goes on to the last of them; the same at the
    // end.
    int first_with_area = 2, last_with_area = count - 1;
    while (first_with_area < count && triangle_to(first_with_area).area == 0)
        ++first_with_area;
    while (last_with_area > 1 && triangle_to(last_with_area).area == 0)
        --last_with_area;
    for (int last = 2; last < count; ++last) {
        FanTriangle triangle = triangle_to(last);
        triangle.is_inner = {last > first_with_area, false, last < last_with_area};
        use(triangle);
    }
}

} // namespace rasterwalk
