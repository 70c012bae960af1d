#pragma once

#include <string_view>
#include <vector>

#include "inspect/clip_history.h"
#include "inspect/row_history.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// One edge of a triangle with its samples.
struct EdgeReport {
    ScreenVertex from, to;           ///< the two vertices as pixels
    int count = 0;                   ///< samples of the whole edge
    std::vector<EdgeSample> samples; ///< those before the given moment
};

/// Everything there is to know about a triangle, whatever the stage draws of it.
struct TriangleReport {
    int triangle = 0;
    Rejection rejection = Rejection::none; ///< why it is not drawn, or none
    std::vector<ShadedVertex> vertices;    ///< of the scene, through the spaces
    ClipHistory clip;                      ///< between vertex shader and division
    std::vector<EdgeReport> edges;         ///< of the drawn part; empty for a triangle left out
    RowHistory rows;                       ///< the row table, empty in the same case
};

/// The report on a triangle of the frame, with its row table as far as it has been made at `to`.
TriangleReport triangle_report(const Frame& frame, int triangle, const Cursor& to = cursor_end);

/// What a sample did to the row table: left, right, both, nothing or outside.
std::string_view write_name(const RowWrite& write);

} // namespace rasterwalk
