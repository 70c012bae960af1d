#include "stages/polygon_rows.h"

#include <algorithm>

namespace rasterwalk {

void begin_polygon_rows(std::span<const Fragment> vertices, const EdgeRules& rules,
                        PolygonRows& rows) {
    const auto [top, bottom] =
        std::minmax_element(vertices.begin(), vertices.end(),
                            [](const Fragment& a, const Fragment& b) { return a.row < b.row; });
    rows.first_row = top->row;
    rows.outside = 0;
    const auto count = static_cast<std::size_t>(bottom->row - top->row + 1);
    Fragment empty;
    const bool is_extreme = rules.row_start == RowStart::extreme;
    empty.column = is_extreme ? empty_left : rules.window_width;
    rows.left.assign(count, empty);
    empty.column = is_extreme ? empty_right : 0;
    rows.right.assign(count, empty);
    for (std::size_t i = 0; i < count; ++i) {
        rows.left[i].row = rows.right[i].row = rows.first_row + static_cast<int>(i);
    }
}

RowWrite add_edge_sample(const Fragment& sample, PolygonRows& rows) {
    const int index = sample.row - rows.first_row;
    if (index < 0 || index >= rows.size()) {
        ++rows.outside;
        return {};
    }
    RowWrite write{true, false, false};
    if (sample.column < rows.left[index].column) {
        rows.left[index] = sample;
        write.left = true;
    }
    if (sample.column > rows.right[index].column) {
        rows.right[index] = sample;
        write.right = true;
    }
    return write;
}

void compute_polygon_rows(std::span<const Fragment> vertices, const EdgeRules& rules,
                          PolygonRows& rows) {
    begin_polygon_rows(vertices, rules, rows);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Fragment& next = vertices[(i + 1) % vertices.size()];
        for (LineWalker edge = walk_edge(vertices[i], next, rules); !edge.done(); edge.advance()) {
            add_edge_sample(edge.sample(), rows);
        }
    }
}

} // namespace rasterwalk
