#pragma once

// Where an edge crosses the row of centres of a row of pixels: the part that scan conversion and
// the active edge list share. Everything is in whole numbers, on the grid of snap.h.

#include <cstdint>

#include "stages/fill_rule.h"
#include "stages/row_end.h"
#include "stages/screen_vertex.h"
#include "stages/snap.h"

namespace rasterwalk {

/// An edge that is not level, from its upper end down.
struct DownEdge {
    GridPoint top, bottom;
    const ScreenVertex* at_top = nullptr; ///< the corner there
    const ScreenVertex* at_bottom = nullptr;
    bool is_inner = false; ///< of a fan: not an edge of the polygon
};

/// A corner of a polygon, and where it is on the grid.
struct SnappedCorner {
    const ScreenVertex& vertex;
    GridPoint point;
};

/// The edge between two corners, which must outlive it; level if both have the same y.
DownEdge down_edge(const SnappedCorner& a, const SnappedCorner& b);

/// The first and the last row of pixels whose centres lie from one height to another, both
/// included: ceil(y - 1/2) and floor(y - 1/2). The same for columns.
int first_row_from(std::int64_t y);
int last_row_to(std::int64_t y);

/// A point on a row of centres: whole + part / parts, in 256ths of a pixel, 0 <= part < parts.
struct RowCrossing {
    std::int64_t whole = 0, part = 0, parts = 1;
    const DownEdge* edge = nullptr; ///< the one that crosses
    float down = 0.0f;              ///< how much of its way down the row lies, 0 to 1

    double x() const {
        return static_cast<double>(whole) + static_cast<double>(part) / static_cast<double>(parts);
    }
    friend bool operator<(const RowCrossing& a, const RowCrossing& b) {
        return a.whole != b.whole ? a.whole < b.whole : a.part * b.parts < b.part * a.parts;
    }
};

/// Where the edge crosses this height; it must reach that height, not be level, and outlive the
/// result.
RowCrossing crossing_at(const DownEdge& edge, std::int64_t y);

/// The pixels of a row whose centres lie between two crossings: from ceil(x_left - 1/2) to
/// ceil(x_right - 1/2) - 1. This holds if the left one owns its points and the right one does not;
/// otherwise the pixels begin after, or end with, a centre that is met exactly.
struct OwnedEnds {
    bool left = true, right = false;
};
struct PixelSpan {
    int first = 0, last = -1; ///< columns; none if the first lies after the last

    bool is_empty() const { return first > last; }
};
PixelSpan pixels_between(const RowCrossing& left, const RowCrossing& right, const OwnedEnds& owned);

/// The values of a row of centres between two crossings: mixed between the ends of each edge, then
/// between both crossings.
class ValuesBetween {
  public:
    ValuesBetween(const RowCrossing& left, const RowCrossing& right, VaryingSet carried);

    /// At the centre of a pixel that lies between them.
    RowEnd at(int column) const;

  private:
    double from_, width_; ///< 256ths of a pixel
    RowEnd left_, right_; ///< the columns are not used
    VaryingSet carried_;
};

} // namespace rasterwalk
