#pragma once

// Mistakes in the slot of stages/lines.h: Bresenham's line, nearly right. Both stay within the box
// of the edge.

#include "stages/lines.h"

namespace rasterwalk {

/// B38, in the slot line: the loop goes from a.x to b.x, and y grows by 1 in a diagonal step. Right
/// for lines that go right and down by at most 1 per column, the first octant; level or too short
/// for the others.
void line_in_first_octant(const LineEnd& a, const LineEnd& b, const LinePart& part,
                          const Stages& stages, std::span<LineSample> result,
                          std::span<LineDecision> decisions);

/// B38, in the slot edge_sample_count: the number of samples of that loop, b.x - a.x + 1. An edge
/// keeps its first sample even where the mistake would leave it none.
int edge_sample_count_to_the_right(const ScreenVertex& a, const ScreenVertex& b);

/// B39, in the slot line: a diagonal step adds -2 l to the decision variable, instead of 2 s - 2 l.
/// Too few diagonal steps follow, and the line ends short of b along its shorter axis.
void line_by_wrong_term(const LineEnd& a, const LineEnd& b, const LinePart& part,
                        const Stages& stages, std::span<LineSample> result,
                        std::span<LineDecision> decisions);

} // namespace rasterwalk
