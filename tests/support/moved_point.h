#pragma once

// Which pixels a polygon covers, by a second implementation without edge functions: it moves
// the pixel's centre by a hair and counts the edges on a ray to the right.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "settings/choices.h"
#include "stages/snap.h"

namespace rasterwalk::test {

/// On which side of the line from a to b a point lies, by a determinant of three rows: 1, -1, or 0
/// on it.
inline int side(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
    const std::int64_t determinant =
        a.x * b.y + b.x * p.y + p.x * a.y - a.y * b.x - b.y * p.x - p.y * a.x;
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

/// The same of a point that is a hair to the right of p, and a much smaller hair below.
inline int side_of_moved(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
    const int exact = side(a, b, p);
    if (exact != 0) return exact;
    if (a.y != b.y) return a.y > b.y ? 1 : -1;
    return a.x < b.x ? 1 : a.x > b.x ? -1 : 0;
}

inline bool lies_between(std::int64_t value, std::int64_t a, std::int64_t b) {
    return std::min(a, b) <= value && value <= std::max(a, b);
}

inline bool is_on_outline(const std::vector<GridPoint>& polygon, const GridPoint& p) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const GridPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (side(a, b, p) == 0 && lies_between(p.x, a.x, b.x) && lies_between(p.y, a.y, b.y))
            return true;
    }
    return false;
}

/// Even and odd: how many edges a ray to the right crosses from the moved point.
inline bool is_moved_inside(const std::vector<GridPoint>& polygon, const GridPoint& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const GridPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        // Moved down by a hair: an upper end counts, a lower end does not.
        const bool down = a.y <= p.y && p.y < b.y, up = b.y <= p.y && p.y < a.y;
        if (down && side_of_moved(a, b, p) > 0) inside = !inside;
        if (up && side_of_moved(b, a, p) > 0) inside = !inside;
    }
    return inside;
}

inline bool is_covered(const std::vector<GridPoint>& polygon, const GridPoint& centre,
                       FillRule rule) {
    if (rule != FillRule::top_left && is_on_outline(polygon, centre))
        return rule == FillRule::inclusive;
    return is_moved_inside(polygon, centre);
}

} // namespace rasterwalk::test
