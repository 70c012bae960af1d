#pragma once

// Scan conversion: a triangle row by row, between its left and its right side.
//
// In:  the corners of a polygon on the screen.
// Out: the first and the last pixel of every row whose centres lie inside, and the values there.
// Picture: cut the triangle by a level line through its middle corner. Each of the two halves has
//          one side on the left and one on the right; go down both together and lay a row of pixels
//          between them.
//
// Pixels are tested at their centres. So the rows of a half go from ceil(y_0 - 1/2) to
// ceil(y_1 - 1/2) - 1 and the columns of a row from ceil(x_left - 1/2) to ceil(x_right - 1/2) - 1,
// with x_left and x_right exactly at the height of the row's centres. That is the top-left rule in
// other words; the other rules move an end by one where a centre lies exactly on it. The pixels are
// those of edge_functions.h; the work grows with the pixels covered, not with the box.
//
// A polygon of more corners is treated as a fan of triangles about its first corner; fan.h says
// what happens to a dent that the snap makes.
//
// The classic mistakes are beginning at the corner instead of the first centre below it, so that
// textures swim; rounding both ends, which draws shared edges twice or not at all; and dividing by
// the height of a level edge.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 3.6.3, on which pixels belong to a span; C. Hecker, "Perspective Texture Mapping", Game
// Developer Magazine, 1995, on centres and ceil.

#include "stages/polygon_corners.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// The slot compute_polygon_rows. There are no edge samples to report.
void rows_by_scan_conversion(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                             PolygonRows& rows, SampleSink* sink);

} // namespace rasterwalk
