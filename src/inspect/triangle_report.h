#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "inspect/row_history.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// One edge of a triangle with its samples.
struct EdgeReport {
    Fragment from, to;               ///< the two vertices as pixels
    int count = 0;                   ///< samples of the whole edge
    std::vector<EdgeSample> samples; ///< those that come before the moment that was asked for
};

/// Everything that is to be known of a triangle, whatever the stage draws of it.
struct TriangleReport {
    int triangle = 0;
    VertexFault left_out = VertexFault::none; ///< why it is not drawn, or none
    std::array<ShadedVertex, 3> vertices;     ///< through the spaces
    std::array<EdgeReport, 3> edges;          ///< empty for a triangle that is left out
    RowHistory rows;                          ///< the row table, likewise
};

/// The report on a triangle of the frame, with its row table as far as it is made at `to`.
TriangleReport triangle_report(const Frame& frame, int triangle, const Cursor& to = cursor_end);

/// What a sample did to the row table: left, right, both, nothing or outside.
std::string_view write_name(const RowWrite& write);

/// The fault as in data: none, not_finite, behind_camera, too_far_out or taken_for_behind.
std::string_view fault_name(VertexFault fault);

} // namespace rasterwalk
