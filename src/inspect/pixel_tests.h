#pragma once

// What edge functions find out about a pixel, in the moment in which they ask it.

#include <optional>
#include <string>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/edge_functions.h"

namespace rasterwalk {

/// The test of a pixel of a row of the box; the piece and the step of its moment.
/// @param index 0 <= index < tested_row_count()
PixelTest test_at_step(const TestedPolygon& polygon, int index, int step, const Stages& stages);

/// The test that is done at a moment; none if none is.
std::optional<PixelTest> test_at(const Frame& frame, const Cursor& cursor);

/// The columns of a row of the box that have been tested at a moment.
/// @param triangle of the frame, to which the row belongs
/// @param index    of the row, 0 <= index < tested_row_count()
ColumnRange tests_done(const TestedRow& row, int triangle, int index, const Cursor& to);

/// The triangle of the fan of which a pixel was tested last at a moment; -1 before the first test.
/// @param triangle of the frame
int fan_triangle_in_test(const TestedPolygon& polygon, int triangle, const Cursor& to);

/// A stretch of a row of the picture whose pixels have been tested, with the same answer.
struct TestedRun {
    int first = 0, last = 0; ///< columns
    bool is_inside = false;  ///< of any triangle of the fan

    friend bool operator==(const TestedRun&, const TestedRun&) = default;
};

/// What the tests have found out about a row of the picture at a moment, from left to right; none
/// overlaps another.
/// @param triangle of the frame
std::vector<TestedRun> tested_runs(const TestedPolygon& polygon, int triangle, int row,
                                   const Cursor& to);

/// The test of a pixel, if it is done at a moment: of a fan, that of the triangle inside which it
/// lies, or else the last one.
/// @param triangle of the frame
std::optional<PixelTest> test_of_pixel(const TestedPolygon& polygon, int triangle, int column,
                                       int row, const Cursor& to, const Stages& stages);

/// What an edge is called that is asked about: "edge 1" of the polygon, or "inner edge" of its fan.
/// @param number as in EdgeFunction
std::string tested_edge_name(int number);

/// The values of the edge functions in square pixels, and what they say: "E = 48, 27, 33: inside",
/// "E = 12, -9, 105: outside, beyond edge 1", "E = 0, 54, 54: outside, edge 0 gives its points
/// away"; of a polygon of more corners "triangle 1 of the fan, E = -3, 9, 8: outside, beyond inner
/// edge". With an ASCII minus.
std::string pixel_test_text(const PixelTest& test);

} // namespace rasterwalk
