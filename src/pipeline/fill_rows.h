#pragma once

#include "pipeline/drawing.h"

namespace rasterwalk {

/// The lab's DrawPolygonRows: every row of a triangle's table, from its left to its right end, both
/// included. If d.row_kernel is set a row is drawn at once, else each fragment separately.
/// @param begin the first moment of the rows, by which the triangle is known
void fill_rows(Drawing& d, const PolygonRows& rows, const Surface& surface, const Cursor& begin);

} // namespace rasterwalk
