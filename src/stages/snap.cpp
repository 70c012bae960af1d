#include "stages/snap.h"

#include <algorithm>
#include <array>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// The nearest of `parts` parts of a pixel, in 256ths. In double, which holds it without error.
std::int64_t nearest_part(float place, int parts) {
    // Rounded down by hand: without SSE4.1 std::floor() is a function call.
    const double above = static_cast<double>(place) * parts + 0.5;
    std::int64_t nearest = static_cast<std::int64_t>(above);
    if (static_cast<double>(nearest) > above) --nearest;
    return nearest * (grid_parts / parts);
}

} // namespace

int pixel_at(std::int64_t coordinate) {
    // Rounded down: the shift keeps the sign.
    static_assert(grid_parts == std::int64_t{1} << 8);
    return static_cast<int>(coordinate >> 8);
}

GridPoint snap_to_centre(const ScreenVertex& vertex) {
    return {pixel_centre(vertex.column), pixel_centre(vertex.row)};
}

GridPoint snap_to_sixteenth(const ScreenVertex& vertex) {
    constexpr int parts = 16;
    return {nearest_part(vertex.position.x, parts), nearest_part(vertex.position.y, parts)};
}

GridPoint snap_to_subpixel(const ScreenVertex& vertex) {
    constexpr int parts = static_cast<int>(grid_parts);
    return {nearest_part(vertex.position.x, parts), nearest_part(vertex.position.y, parts)};
}

void snap_corners(PolygonCorners vertices, const Stages& stages, std::vector<GridPoint>& points,
                  const GridPoint& sample) {
    points.clear();
    for (const ScreenVertex& vertex : vertices) {
        const GridPoint point = stages.snap(vertex);
        points.push_back({point.x - sample.x, point.y - sample.y});
    }
}

Rectangle touched_pixels(std::span<const GridPoint> points) {
    const GridPoint& first = points[0];
    Rectangle box{pixel_at(first.x), pixel_at(first.y), pixel_at(first.x), pixel_at(first.y)};
    for (const GridPoint& point : points) {
        box.left = std::min(box.left, pixel_at(point.x));
        box.right = std::max(box.right, pixel_at(point.x));
        box.top = std::min(box.top, pixel_at(point.y));
        box.bottom = std::max(box.bottom, pixel_at(point.y));
    }
    return {box.left, box.top, box.right + 1, box.bottom + 1};
}

Rectangle snapped_box(PolygonCorners vertices, const EdgeRules&, const Stages& stages) {
    GridPoint least = stages.snap(vertices[0]), most = least;
    for (const ScreenVertex& vertex : vertices) {
        const GridPoint point = stages.snap(vertex);
        least = {std::min(least.x, point.x), std::min(least.y, point.y)};
        most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    return touched_pixels(std::array{least, most});
}

} // namespace rasterwalk
