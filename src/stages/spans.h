#pragma once

// Spans: from the two ends of a row to its fragments.
//
// In:  the left and right end of one row of the table.
// Out: how many fragments the row has, and how many of them are drawn.
// Picture: a row of bricks from the left end to the right one, both included: right - left + 1.
//
// The classic mistakes are `<` for `<=`, which leaves out the last column and opens gaps between
// neighbours; leaving out rows of a single pixel, which takes off the tips; drawing rows that no
// sample has reached, where right - left + 1 does not fit an int; and multiplying the varyings by
// 1/z a second time here, although the vertices have already done it.
//
// Source: Foley, van Dam, Feiner, Hughes, Computer Graphics: Principles and Practice, 2nd edition,
// section 3.6.3, on spans and which of their ends belong to them.

#include <span>

#include "stages/edge_functions.h"
#include "stages/interpolate.h"
#include "stages/row_end.h"

namespace rasterwalk {

/// How many pixels a row has from its left to its right end, both included; 0 for a row that no
/// edge sample has reached.
constexpr int row_pixel_count(int left, int right) {
    return left > right ? 0 : right - left + 1;
}

/// How many of a row's pixels are drawn, counted from its left end: all of them.
constexpr int drawn_pixels(int pixel_count) {
    return pixel_count;
}

/// An end of a row as passed to the walk along the row: as the table has it.
inline RowEnd span_end(const RowEnd& end) {
    return end;
}

/// A row of the picture, from end to end.
struct Row {
    const RowEnd& left;
    const RowEnd& right;
    int row = 0;                           ///< of the picture
    int count = 0;                         ///< pixels from end to end
    const TestedPolygon* tested = nullptr; ///< whose row it is, if it mixes corners
};

/// The fragments `first`, `first` + 1, ... of a row, counted from its left end: as many as `result`
/// holds. They are in the row's own columns; their values are walked from end to end.
void row_fragments(const Stages& stages, const Row& row, int first, VaryingSet carried,
                   std::span<LineSample> result);

} // namespace rasterwalk
