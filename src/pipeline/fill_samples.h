#pragma once

// The drawing of pixels with several samples: in place of fill_rows, and at the end of the frame.

#include "pipeline/drawing.h"

namespace rasterwalk {

/// fill_rows() for pixels with several samples: a fragment for each pixel of a row of which the
/// polygon covers a sample, in the row's order. With multisampling it is culled, cut out and shaded
/// once, by its values at the pixel's centre; with supersampling all that happens at each sample.
/// @param begin the first moment of the rows, by which the triangle is known
void fill_sample_rows(Drawing& d, const PolygonRows& rows, const Surface& surface,
                      const Cursor& begin);

/// After all triangles: gives each pixel the colour that its samples make together.
void resolve_pixels(Drawing& d);

} // namespace rasterwalk
