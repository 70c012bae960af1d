#include "stages/scan_conversion.h"

#include <algorithm>
#include <array>
#include <utility>

#include "stages/fan.h"
#include "stages/row_crossing.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// The two sides of a half triangle.
struct HalfSides {
    const DownEdge& left;
    const DownEdge& right;
    OwnedEnds owned; ///< inner edges of a fan go by the top-left rule
};

/// What all triangles of a polygon have in common.
struct ScanConversion {
    OwnedEnds owned;
    bool owns_top, owns_bottom; ///< the points of level edges
    GridPoint corner;           ///< the one that the fan is laid about
    bool owns_corner;
    VaryingSet carried;
    PolygonRows& rows;

    /// Lays a row of pixels. A row already laid there by other triangles of the polygon is
    /// lengthened.
    void set_row(const HalfSides& sides, int row) {
        const std::int64_t y = pixel_centre(row);
        const RowCrossing left = crossing_at(sides.left, y);
        const RowCrossing right = crossing_at(sides.right, y);
        PixelSpan span = pixels_between(left, right, sides.owned);
        const bool begins_at_corner = corner == GridPoint{pixel_centre(span.first), y};
        if (begins_at_corner && !owns_corner) ++span.first;
        if (span.is_empty()) return;
        const auto i = static_cast<std::size_t>(row - rows.first_row);
        const ValuesBetween values(left, right, carried);
        if (span.first < rows.left[i].column) rows.left[i] = values.at(span.first);
        if (span.last > rows.right[i].column) rows.right[i] = values.at(span.last);
    }
    void set_rows(const HalfSides& sides, int first, int last) {
        for (int row = first; row <= last; ++row)
            set_row(sides, row);
    }
};

/// The first row whose centres lie at a height or below it; only below it, if a level edge there
/// does not own its points.
int first_row_below(std::int64_t y, bool is_owned) {
    const int row = first_row_from(y);
    return !is_owned && pixel_centre(row) == y ? row + 1 : row;
}

/// The corners of a triangle from top to bottom; of two at the same height the first stays first.
std::array<std::size_t, 3> from_top_to_bottom(const FanTriangle& triangle) {
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto sort_pair = [&](std::size_t upper, std::size_t lower) {
        if (triangle.points[order[lower]].y < triangle.points[order[upper]].y)
            std::swap(order[upper], order[lower]);
    };
    sort_pair(0, 1);
    sort_pair(1, 2);
    sort_pair(0, 1);
    return order;
}

/// Does the box of a triangle hold the centre of any pixel? The boxes of a dense mesh often hold
/// none.
bool holds_centre(const FanTriangle& triangle) {
    const auto [a, b, c] = triangle.points;
    return first_row_from(std::min({a.y, b.y, c.y})) <= last_row_to(std::max({a.y, b.y, c.y})) &&
           first_row_from(std::min({a.x, b.x, c.x})) <= last_row_to(std::max({a.x, b.x, c.x}));
}

void convert_triangle(const FanTriangle& triangle, PolygonCorners vertices,
                      ScanConversion& conversion) {
    if (triangle.area == 0 || !holds_centre(triangle)) return;
    const std::array<std::size_t, 3> order = from_top_to_bottom(triangle);
    const auto corner = [&](std::size_t i) {
        return SnappedCorner{vertices[static_cast<std::size_t>(triangle.corners[i])],
                             triangle.points[i]};
    };
    const auto edge_between = [&](std::size_t a, std::size_t b) {
        DownEdge edge = down_edge(corner(a), corner(b));
        // Edge i begins at corner i: of the two corners, the one followed by the other.
        edge.is_inner = triangle.is_inner[(a + 1) % 3 == b ? a : b];
        return edge;
    };
    const auto [top, middle, bottom] = order;
    const DownEdge upper = edge_between(top, middle), lower = edge_between(middle, bottom),
                   whole = edge_between(top, bottom);
    const std::int64_t area =
        double_area(triangle.points[top], triangle.points[middle], triangle.points[bottom]);
    const bool is_middle_right = area > 0;
    const auto sides = [&](const DownEdge& shorter) {
        const DownEdge &left = is_middle_right ? whole : shorter,
                       &right = is_middle_right ? shorter : whole;
        return HalfSides{
            left,
            right,
            {left.is_inner || conversion.owned.left, !right.is_inner && conversion.owned.right}};
    };
    const std::int64_t split = upper.bottom.y;
    const bool has_level_top = upper.top.y == split, has_level_bottom = lower.bottom.y == split;
    // A row of centres through the middle corner belongs to the lower half, if there is one.
    if (!has_level_top) {
        const bool keeps_last = has_level_bottom && !lower.is_inner && conversion.owns_bottom;
        conversion.set_rows(sides(upper), first_row_from(upper.top.y),
                            keeps_last ? last_row_to(split) : first_row_from(split) - 1);
    }
    if (!has_level_bottom) {
        const bool keeps_first = !has_level_top || upper.is_inner || conversion.owns_top;
        int first = first_row_below(split, keeps_first);
        if (!has_level_top && pixel_centre(first) == split) {
            // The middle corner lies on both of its edges.
            HalfSides at_corner = sides(lower);
            const OwnedEnds above = sides(upper).owned;
            at_corner.owned = {at_corner.owned.left && above.left,
                               at_corner.owned.right && above.right};
            conversion.set_rows(at_corner, first, first);
            ++first;
        }
        conversion.set_rows(sides(lower), first, last_row_to(lower.bottom.y));
    }
}

} // namespace

void rows_by_scan_conversion(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                             PolygonRows& rows, SampleSink* sink) {
    snap_corners(vertices, stages, rows.points, rules.sample);
    const Rectangle box = touched_pixels(rows.points);
    empty_table(box.top, box.bottom - box.top, rows);
    const auto owns = [&](const EdgeDirection& side) { return stages.edge_owns_points(side); };
    ScanConversion conversion{.owned = {owns(left_side), owns(right_side)},
                              .owns_top = owns(top_side),
                              .owns_bottom = owns(bottom_side),
                              .corner = rows.points[0],
                              .owns_corner = owns_any(stages.edge_owns_points),
                              .carried = rules.carried,
                              .rows = rows};
    for_each_fan_triangle(rows.points, [&](const FanTriangle& triangle) {
        convert_triangle(triangle, vertices, conversion);
    });
    if (sink != nullptr) sink->rows_without_samples(rows);
}

} // namespace rasterwalk
