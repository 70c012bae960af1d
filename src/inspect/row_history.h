#pragma once

// The writers of a row table: how the two ends of every row of a polygon came about. Listens to the
// coverage stage, whatever function is there.

#include <climits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/active_edges.h"
#include "stages/polygon_corners.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// The edge sample that wrote an end of a row. Counts from 0.
struct EndWriter {
    int edge = -1;    ///< -1: no sample has reached the row yet
    int sample = -1;  ///< of the edge
    int replaced = 0; ///< how many earlier samples were replaced here

    bool is_set() const { return edge >= 0; }
    friend bool operator==(const EndWriter&, const EndWriter&) = default;
};

/// An edge sample that fell in no row of the table.
struct OutsideSample {
    int edge = 0;
    int sample = 0;
    float x = 0.0f, y = 0.0f; ///< its position before rounding, pixels
    int column = 0, row = 0;  ///< where it would have been written

    friend bool operator==(const OutsideSample&, const OutsideSample&) = default;
};

/// The row table of a polygon with its history. Coverage that tests pixels at their centres enters
/// no samples: its ends have no writers.
struct RowHistory {
    PolygonRows rows;
    std::vector<EndWriter> left_by;  ///< for each row of the table
    std::vector<EndWriter> right_by; ///< for each row of the table
    std::vector<OutsideSample> outside;
    std::vector<int> edge_samples;  ///< for each edge, how many samples it has
    int samples = 0;                ///< entered so far
    int sample_count = 0;           ///< of all edges
    std::optional<EdgeSample> last; ///< the sample entered last
    int last_index = -1;            ///< of the row it was entered in; -1: outside the table
    /// If active edges made the table: all stretches that lie inside, from top to bottom and left
    /// to right. A row of the table reaches from the first of its row to the last. Else empty.
    std::vector<InsideSpan> spans;
};

/// The stretches of a row of the picture; none if coverage has none.
std::span<const InsideSpan> spans_of_row(const RowHistory& history, int row);

/// The table of a drawn triangle, as far as it has been made at `to`.
RowHistory row_history(const Frame& frame, int triangle, const Cursor& to = cursor_end);

/// The table of a polygon of at least one vertex, after the first `samples` samples of its edges,
/// counted over all edges in order.
RowHistory row_history(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                       int samples = INT_MAX);

/// The samples of a drawn triangle's edges that come before `to`, in order, and what each did.
std::vector<EdgeSample> edge_samples(const Frame& frame, int triangle,
                                     const Cursor& to = cursor_end);

/// The table in the lab's form, one line per row: `Start: (10,5). End: (10,5).`
std::string rows_text(const PolygonRows& rows);

} // namespace rasterwalk
