#pragma once

// Where an edge crosses the row of centres of a row of pixels: what scan conversion and the active
// edge list have in common. Everything in whole numbers, on the grid of snap.h.

#include <cstdint>

#include "stages/fill_rule.h"
#include "stages/row_end.h"
#include "stages/screen_vertex.h"
#include "stages/snap.h"

namespace rasterwalk {

struct Stages;

/// An edge that is not level, from its upper end down.
struct DownEdge {
    GridPoint top, bottom;
    RowEnd at_top, at_bottom; ///< the values there; the columns say nothing
    bool is_inner = false;    ///< of a fan: no edge of the polygon

    bool reaches(std::int64_t y) const { return top.y <= y && y <= bottom.y; }
};

/// The edge between two vertices; level if both ends have the same y.
DownEdge down_edge(const ScreenVertex& a, const ScreenVertex& b, const Stages& stages);

/// The first and the last row of pixels whose centres lie from one height to another, both
/// included: ceil(y - 1/2) and floor(y - 1/2).
int first_row_from(std::int64_t y);
int last_row_to(std::int64_t y);

/// A place on a row of centres: whole + part / parts, in 256ths of a pixel, 0 <= part < parts.
struct RowCrossing {
    std::int64_t whole = 0, part = 0, parts = 1;
    RowEnd values; ///< mixed between the ends of the edge; the column says nothing

    double x() const {
        return static_cast<double>(whole) + static_cast<double>(part) / static_cast<double>(parts);
    }
    friend bool operator<(const RowCrossing& a, const RowCrossing& b) {
        return a.whole != b.whole ? a.whole < b.whole : a.part * b.parts < b.part * a.parts;
    }
};

/// Where the edge crosses this height; it must reach it, and not be level.
RowCrossing crossing_at(const DownEdge& edge, std::int64_t y, VaryingSet carried);

/// The pixels of a row whose centres lie between two crossings: from ceil(x_left - 1/2) to
/// ceil(x_right - 1/2) - 1. That is so where the left one owns its points and the right one does
/// not; else it begins behind, or ends with, a centre that is met exactly.
struct OwnedEnds {
    bool left = true, right = false;
};
struct PixelSpan {
    int first = 0, last = -1; ///< columns; there are none where the first lies behind the last

    bool is_empty() const { return first > last; }
};
PixelSpan pixels_between(const RowCrossing& left, const RowCrossing& right, const OwnedEnds& owned);

/// The values at the centre of a pixel that lies between two crossings.
RowEnd value_between(const RowCrossing& left, const RowCrossing& right, int column,
                     VaryingSet carried);

} // namespace rasterwalk
