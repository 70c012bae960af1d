#pragma once

// The active edge list: a polygon of any shape, row by row.
//
// In:  the corners of a polygon on the screen; it can have dents and can cross itself.
// Out: for every row, the stretches that lie inside, from left to right.
// Picture: a broom sweeps over the polygon from top to bottom. It keeps a list of the edges that it
//          touches at the moment; between the first and the second of them is the inside, between
//          the second and the third the outside, and so on.
//
// No triangles are needed, so nothing depends on how a polygon is cut into them. A row table with
// one left and one right end per row fills the dents, and so does a fan of triangles.
//
// Rows and columns are those of scan_conversion.h: ceil(. - 1/2) of where an edge begins and ends,
// and of where a row meets it. So an edge counts at its upper end and not at its lower one, and a
// corner at which one edge ends and the next begins is met once.
//
// The classic mistake is to count a corner twice: inside and outside are swapped for the rest of
// the row.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 3.6.3, the scan-line algorithm with edge table and active-edge table.

#include <vector>

#include "stages/polygon_corners.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// A stretch of a row that lies inside.
struct InsideSpan {
    int row = 0;        ///< of the picture
    RowEnd left, right; ///< its first and its last pixel

    friend bool operator==(const InsideSpan&, const InsideSpan&) = default;
};

/// All stretches of a polygon, from top to bottom and from left to right; none overlaps another.
/// @param vertices at least one
std::vector<InsideSpan> active_edge_spans(PolygonCorners vertices, const EdgeRules& rules,
                                          const Stages& stages);

/// The slot compute_polygon_rows. A table has one left and one right end per row: for a polygon
/// with dents it holds the first and the last of active_edge_spans(). The pipeline's polygons have
/// no dents, except where the snap to whole pixels bends a cut polygon inward. There the ends of a
/// row can differ by a pixel from those of a fan, which fills the dent (fan.h).
void rows_by_active_edges(PolygonCorners vertices, const EdgeRules& rules, const Stages& stages,
                          PolygonRows& rows, SampleSink* sink);

} // namespace rasterwalk
