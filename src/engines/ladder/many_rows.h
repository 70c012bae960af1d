#pragma once

// Rows of a triangle, drawn many pixels at a time: shared by the rungs from many_at_a_time on.

#include "engines/ladder/parts.h"
#include "engines/ladder/screen_triangle.h"

namespace rasterwalk::rungs {

/// Draws the rows of a triangle from first_row to before end_row.
void draw_rows(const ScreenTriangle& triangle, int first_row, int end_row, const PixelLight& light,
               const Lab& lab);

} // namespace rasterwalk::rungs
