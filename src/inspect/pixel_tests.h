#pragma once

// What edge functions find out about a pixel, in the moment in which they ask it.

#include <optional>
#include <string>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "stages/edge_functions.h"

namespace rasterwalk {

/// The test of a pixel of a row of the box; the piece and the step of its moment.
/// @param index 0 <= index < tested_row_count()
PixelTest test_at_step(const TestedPolygon& polygon, int index, int step, const Stages& stages);

/// The test that is done at a moment; none if none is.
std::optional<PixelTest> test_at(const Frame& frame, const Cursor& cursor);

/// What an edge is called that is asked about: "edge 1" of the polygon, or "inner edge" of its fan.
/// @param number as in EdgeFunction
std::string tested_edge_name(int number);

/// The values of the edge functions in square pixels, and what they say: "E = 48, 27, 33: inside",
/// "E = 12, -9, 105: outside, beyond edge 1", "E = 0, 54, 54: outside, edge 0 gives its points
/// away"; of a polygon of more corners "triangle 1 of the fan, E = -3, 9, 8: outside, beyond inner
/// edge". With an ASCII minus.
std::string pixel_test_text(const PixelTest& test);

} // namespace rasterwalk
