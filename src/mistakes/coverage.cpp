#include "mistakes/coverage.h"

#include <algorithm>
#include <cstdlib>

namespace rasterwalk {

int edge_sample_count_by_rows(const ScreenVertex& a, const ScreenVertex& b) {
    return std::abs(a.row - b.row) + 1;
}

int edge_sample_count_shifted(const ScreenVertex& a, const ScreenVertex& b) {
    return std::max({std::abs(a.column - b.column + 1), std::abs(a.row - b.row + 1), 1});
}

void begin_rows_at_picture(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows) {
    begin_polygon_rows(vertices, rules, rows);
    // If it gets no sample, such a row is drawn with its start values.
    RowEnd end;
    end.column = rules.picture_width;
    rows.left.assign(rows.left.size(), end);
    end.column = 0;
    rows.right.assign(rows.right.size(), end);
}

void begin_rows_without_last(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows) {
    begin_polygon_rows(vertices, rules, rows);
    if (rows.size() > 1) empty_table(rows.first_row, rows.size() - 1, rows);
}

FoundRow find_nearest_row(int row, const PolygonRows& rows) {
    return {std::clamp(row - rows.first_row, 0, rows.size() - 1), 1};
}

Rectangle polygon_box_at_picture(PolygonCorners vertices, const EdgeRules& rules,
                                 const Stages& stages) {
    Rectangle box = polygon_box(vertices, rules, stages);
    box.left = std::min(box.left, rules.picture_width);
    box.right = std::max(box.right, 1);
    return box;
}

FoundRow find_row_among_all(int row, const PolygonRows& rows) {
    FoundRow found{-1, rows.size()};
    if (rows.lookups >= most_row_lookups) {
        found.index = find_row(row, rows).index;
        return found;
    }
    for (int i = 0; i < rows.size(); ++i) {
        if (rows.first_row + i == row) found.index = i;
    }
    return found;
}

int row_pixel_count_wrapped(int left, int right) {
    return static_cast<int>(static_cast<std::uint32_t>(right) - static_cast<std::uint32_t>(left) +
                            1u);
}

int drawn_pixels_without_single(int pixel_count) {
    return pixel_count == 1 ? 0 : pixel_count;
}

int drawn_pixels_without_last(int pixel_count) {
    return pixel_count > 0 ? pixel_count - 1 : 0;
}

Weights weights_of_own_edges(const EdgeValues& e, std::int64_t area) {
    const Weights right = barycentric_weights(e, area);
    // Edge 0, which is opposite corner 2, begins at corner 0.
    return {right[2], right[0], right[1]};
}

} // namespace rasterwalk
