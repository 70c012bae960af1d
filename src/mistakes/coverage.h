#pragma once

// Mistakes in the slots of stages/edges.h, stages/polygon_rows.h and stages/spans.h, and in those
// of stages/fill_rule.h, stages/snap.h and stages/edge_functions.h.

#include "stages/edge_functions.h"
#include "stages/fill_rule.h"
#include "stages/polygon_corners.h"
#include "stages/polygon_rows.h"
#include "stages/snap.h"

namespace rasterwalk {

/// B5, in the slot edge_sample_count: |dy| + 1, one sample per row; shallow edges become dots.
int edge_sample_count_by_rows(const ScreenVertex& a, const ScreenVertex& b);

/// B12, in the slot edge_sample_count: the + 1 is inside the bars,
/// max(|ax - bx + 1|, |ay - by + 1|). An edge keeps its first sample even where the mistake would
/// leave it none.
int edge_sample_count_shifted(const ScreenVertex& a, const ScreenVertex& b);

/// B91, in the slot entered_samples: the loop over the samples of an edge ends before the last. The
/// next edge begins there; only an edge of a single sample has none left.
constexpr int entered_without_last(int count, bool) {
    return count - 1;
}

/// B94, in the slot entered_samples: the loop over the edges ends before the last, which leads back
/// to the first vertex.
constexpr int entered_without_last_edge(int count, bool is_last_edge) {
    return is_last_edge ? 0 : count;
}

/// B6, in the slot begin_polygon_rows: the left ends start at the picture's width and the right
/// ends at 0, which is not extreme enough: phantom pixels for polygons outside the picture.
void begin_rows_at_picture(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows);

/// The box that goes with begin_rows_at_picture: rows also reach to where their ends started.
Rectangle polygon_box_at_picture(PolygonCorners vertices, const EdgeRules& rules,
                                 const Stages& stages);

/// B95, in the slot begin_polygon_rows: the table has bottom - top rows, without the + 1, and the
/// samples of the last row fall below it. Guarded: a level polygon keeps its row.
void begin_rows_without_last(PolygonCorners vertices, const EdgeRules& rules, PolygonRows& rows);

/// B93, in the slot find_row: a sample above the table goes in its first row, one below it in its
/// last.
FoundRow find_nearest_row(int row, const PolygonRows& rows);

/// B90, in the slot row_end: the row takes the column of a sample, and all other values stay at
/// their start value 0.
inline RowEnd row_end_of_column(const Fragment& sample) {
    RowEnd end;
    end.column = sample.column;
    return end;
}

/// B27, in the slot find_row: searches every row of the table for the right one. The answer is the
/// same, the work is not. Guarded: a table is searched until its samples have looked at
/// most_row_lookups rows; after that the searches are only counted.
FoundRow find_row_among_all(int row, const PolygonRows& rows);

inline constexpr std::int64_t most_row_lookups = 2'000'000;

/// B7, in the slot row_pixel_count: rows that no edge sample has reached are not left out, and
/// right - left + 1 wraps around in 32 bits: with -INT_MAX and +INT_MAX it is 3. Guarded: their
/// columns lie far outside every picture, so put_pixel refuses all of them.
int row_pixel_count_wrapped(int left, int right);

/// B8, in the slot drawn_pixels: a row of a single pixel is left out.
int drawn_pixels_without_single(int pixel_count);

/// B9, in the slot drawn_pixels: `<` for `<=`, all pixels of the row but the last.
int drawn_pixels_without_last(int pixel_count);

/// B40c, in the slot edge_owns_points: only left edges own their points. Level edges have no owner,
/// so two polygons that share one leave a row between them where it runs through centres.
constexpr bool owns_left_only(const EdgeDirection& edge) {
    return edge.dy < 0;
}

/// B41, in the slot snap: pixels are tested at their upper left corner. It is half a pixel to the
/// left of the centre and above it, so the answer is the centre's for a polygon half a pixel
/// further to the right and further down.
template <GridPoint (*snap)(const ScreenVertex& vertex)>
GridPoint snap_for_corners(const ScreenVertex& vertex) {
    const GridPoint point = snap(vertex);
    return {point.x + grid_parts / 2, point.y + grid_parts / 2};
}

/// B42, in the slot weights: each corner has the weight of the edge that begins at it instead of
/// the opposite edge's. The sum is 1 all the same.
Weights weights_of_own_edges(const EdgeValues& e, std::int64_t area);

} // namespace rasterwalk
