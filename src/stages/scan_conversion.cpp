#include "stages/scan_conversion.h"

#include <algorithm>
#include <array>

#include "stages/row_crossing.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// The two sides of a half triangle.
struct HalfSides {
    const DownEdge& left;
    const DownEdge& right;
};

/// What is the same for all triangles of a polygon.
struct ScanConversion {
    OwnedEnds owned;
    bool owns_top, owns_bottom; ///< the points of level edges
    VaryingSet carried;
    PolygonRows& rows;

    /// Lays a row of pixels. What other triangles of the polygon have laid there it lengthens.
    void lay_row(const HalfSides& sides, int row) {
        const std::int64_t y = pixel_centre(row);
        const RowCrossing left = crossing_at(sides.left, y, carried);
        const RowCrossing right = crossing_at(sides.right, y, carried);
        const PixelSpan span = pixels_between(left, right, owned);
        if (span.is_empty()) return;
        const auto i = static_cast<std::size_t>(row - rows.first_row);
        if (span.first < rows.left[i].column)
            rows.left[i] = value_between(left, right, span.first, carried);
        if (span.last > rows.right[i].column)
            rows.right[i] = value_between(left, right, span.last, carried);
    }
    void lay_rows(const HalfSides& sides, int first, int last) {
        for (int row = first; row <= last; ++row)
            lay_row(sides, row);
    }
};

/// The first row that does not begin before a height; of an edge there that is level and does not
/// own its points, behind it.
int first_row_below(std::int64_t y, bool is_owned) {
    const int row = first_row_from(y);
    return !is_owned && pixel_centre(row) == y ? row + 1 : row;
}

void convert_triangle(std::array<const ScreenVertex*, 3> corners, const Stages& stages,
                      ScanConversion& conversion) {
    std::sort(corners.begin(), corners.end(), [&](const ScreenVertex* a, const ScreenVertex* b) {
        return stages.snap(*a).y < stages.snap(*b).y;
    });
    const auto& [top, middle, bottom] = corners;
    const std::int64_t area =
        double_area(stages.snap(*top), stages.snap(*middle), stages.snap(*bottom));
    if (area == 0) return;
    const DownEdge upper = down_edge(*top, *middle, stages);
    const DownEdge lower = down_edge(*middle, *bottom, stages);
    const DownEdge whole = down_edge(*top, *bottom, stages);
    const bool is_middle_right = area > 0;
    const auto sides = [&](const DownEdge& shorter) {
        return is_middle_right ? HalfSides{whole, shorter} : HalfSides{shorter, whole};
    };
    const std::int64_t split = upper.bottom.y;
    const bool has_level_top = upper.top.y == split, has_level_bottom = lower.bottom.y == split;
    // A row of centres through the middle corner belongs to the lower half, if there is one.
    if (!has_level_top) {
        const int last = has_level_bottom && conversion.owns_bottom ? last_row_to(split)
                                                                    : first_row_from(split) - 1;
        conversion.lay_rows(sides(upper), first_row_from(upper.top.y), last);
    }
    if (!has_level_bottom) {
        const int first = first_row_below(split, !has_level_top || conversion.owns_top);
        conversion.lay_rows(sides(lower), first, last_row_to(lower.bottom.y));
    }
}

} // namespace

void rows_by_scan_conversion(std::span<const ScreenVertex> vertices, const EdgeRules& rules,
                             const Stages& stages, PolygonRows& rows, SampleSink* sink) {
    const Rectangle box = snapped_box(vertices, rules, stages);
    empty_table(box.top, box.bottom - box.top, rows);
    const auto owns = [&](const EdgeDirection& side) { return stages.edge_owns_points(side); };
    ScanConversion conversion{{owns(left_side), owns(right_side)},
                              owns(top_side),
                              owns(bottom_side),
                              rules.carried,
                              rows};
    for (std::size_t i = 2; i < vertices.size(); ++i)
        convert_triangle({&vertices[0], &vertices[i - 1], &vertices[i]}, stages, conversion);
    if (sink != nullptr) sink->rows_without_samples(rows);
}

} // namespace rasterwalk
