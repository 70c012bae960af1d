#pragma once

#include "pipeline/drawing.h"

namespace rasterwalk {

/// The lab's DrawPolygonRows: every row of the triangle's table, `d.rows`, from its left to its
/// right end, both included. If d.row_kernel is set a row is drawn at once, else each fragment
/// separately.
void fill_rows(Drawing& d, int triangle);

} // namespace rasterwalk
