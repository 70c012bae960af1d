#pragma once

// The tests of edge functions as moments: coverage has already solved them row by row; here they
// are reported pixel by pixel.

#include <cstdint>

#include "pipeline/drawing.h"

namespace rasterwalk {

/// Reports to the observer the tested pixels of a triangle that lie in the window and the scissor,
/// row by row of the box. The drawing holds its row table.
void notify_pixel_tests(const Drawing& d, int triangle);

/// How many of the tested pixels of a polygon lie in the picture.
std::int64_t count_pixel_tests(const Frame& frame, const TestedPolygon& tested);

} // namespace rasterwalk
