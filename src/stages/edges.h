#pragma once

// Edges: the outline of a polygon, pixel by pixel.
//
// In:  two projected vertices.
// Out: how many samples the edge between them has, and the walk along them.
// Picture: a line in which every step goes one pixel along the longer axis, so that it has no
// holes.
//
// The classic mistake is to count by the rows alone, |dy| + 1: steep lines look right, and shallow
// ones become dots, one a row. A row table made so passes the lab's own printed test. The other is
// to put the + 1 inside the bars, |a - b + 1|: lines that go right or down then lack two samples,
// and take steps that leave holes.

#include <cstdint>

#include "stages/interpolate.h"

namespace rasterwalk {

/// How many samples an edge has.
enum class EdgeSamples : std::uint8_t {
    longest_axis, ///< max(|dx|, |dy|) + 1: the lab
    rows,         ///< |dy| + 1: mistake B5, shallow edges get one sample a row
    shifted,      ///< max(|ax - bx + 1|, |ay - by + 1|): mistake B12
};

/// Where the two ends of a row stand in the table before its first sample.
enum class RowStart : std::uint8_t {
    extreme, ///< left at +INT_MAX, right at -INT_MAX: the lab
    window,  ///< left at the picture's width, right at 0: mistake B6, phantom pixels beside it
};

/// The rules by which edges are made and entered in the row table.
struct EdgeRules {
    LineRules line;
    EdgeSamples samples = EdgeSamples::longest_axis;
    RowStart row_start = RowStart::extreme;
    int window_width = 0; ///< of the picture, pixels; for RowStart::window
};

/// Number of samples of the edge from a to b, both ends included; at least 1.
int edge_sample_count(const Fragment& a, const Fragment& b, EdgeSamples rule);

/// The walk along the edge from a to b.
LineWalker walk_edge(const Fragment& a, const Fragment& b, const EdgeRules& rules);

} // namespace rasterwalk
