#pragma once

// Edges: the outline of a polygon, pixel by pixel. All outlines together are the wireframe. lines.h
// says how the samples between the two ends are found.
//
// In:  two projected vertices.
// Out: how many samples the edge between them has.
// Picture: a line in which every step goes one pixel along the longer axis, so that it has no
//          holes.
//
// The classic mistake is to count by the rows alone, |dy| + 1: steep lines look right, but shallow
// ones become dots, one per row. A row table made this way passes the lab's own printed test.
// Another is to put the + 1 inside the bars, |a - b + 1|: lines that go right or down then lack two
// samples, and their longer steps leave holes. Others lose samples on the way into the table: the
// last one of every edge, or all of the edge that leads back to the first vertex.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 3.2, scan converting lines.

#include "stages/screen_vertex.h"

namespace rasterwalk {

/// Number of samples of the edge from a to b, both ends included: max(|dx|, |dy|) + 1.
int edge_sample_count(const ScreenVertex& a, const ScreenVertex& b);

/// How many of an edge's samples, counted from the first, are entered in the row table: all of
/// them.
/// @param is_last_edge the one that leads back to the polygon's first vertex
constexpr int entered_samples(int count, [[maybe_unused]] bool is_last_edge) {
    return count;
}

} // namespace rasterwalk
