#pragma once

// The results of edge functions for a pixel, at the moment they test it.

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

/// The test that is done at a moment; none if there is none.
std::optional<PixelTest> test_at(const Frame& frame, const Cursor& cursor);

/// The columns of a row from the first to the last pixel inside a triangle of the fan: by their
/// centres, or if pixels have samples by any of these.
ColumnRange inside_columns(const TestedPolygon& polygon, const TestedTriangle& triangle, int row);

/// The columns of a row of the box that have been tested at a moment.
/// @param triangle of the frame, which the row belongs to
/// @param index    of the row, 0 <= index < tested_row_count()
ColumnRange tests_done(const TestedRow& row, int triangle, int index, const Cursor& to);

/// The triangle of the fan for which a pixel was last tested at a moment; -1 before the first test.
/// @param triangle of the frame
int fan_triangle_in_test(const TestedPolygon& polygon, int triangle, const Cursor& to);

/// A stretch of a row of the picture whose pixels have been tested, with the same answer.
struct TestedRun {
    int first = 0, last = 0; ///< columns
    bool is_inside = false;  ///< of any triangle of the fan

    friend bool operator==(const TestedRun&, const TestedRun&) = default;
};

/// The results of the tests for a row of the picture at a moment, from left to right; none overlaps
/// another.
/// @param triangle of the frame
std::vector<TestedRun> tested_runs(const TestedPolygon& polygon, int triangle, int row,
                                   const Cursor& to);

/// The test of a pixel, if it is done at a moment: in a fan, the test for the triangle it lies
/// inside, or else the last one.
/// @param triangle of the frame
std::optional<PixelTest> test_of_pixel(const TestedPolygon& polygon, int triangle, int column,
                                       int row, const Cursor& to, const Stages& stages);

/// The name of a tested edge: "edge 1" of the polygon, or "inner edge" of its fan.
/// @param number as in EdgeFunction
std::string tested_edge_name(int number);

/// The values of the edge functions in square pixels, and the answer: "E = 48, 27, 33: inside",
/// "E = 12, -9, 105: outside, beyond edge 1",
/// "E = 0, 54, 54: outside, edge 0 leaves its points to the neighbour"; for a polygon with more
/// corners "triangle 1 of the fan, E = -3, 9, 8: outside, beyond inner edge". With an ASCII minus.
std::string pixel_test_text(const PixelTest& test);

} // namespace rasterwalk
