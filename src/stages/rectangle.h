#pragma once

#include <algorithm>

namespace rasterwalk {

/// Pixels from (left, top) up to, not including, (right, bottom).
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;

    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// Are there no pixels in it?
constexpr bool is_empty(const Rectangle& r) {
    return r.left >= r.right || r.top >= r.bottom;
}

/// Is this pixel in it?
constexpr bool contains(const Rectangle& r, int column, int row) {
    return column >= r.left && column < r.right && row >= r.top && row < r.bottom;
}

/// The part common to both; empty if there is none.
constexpr Rectangle intersection(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

/// The smallest rectangle around both; one without pixels does not count.
constexpr Rectangle around(const Rectangle& a, const Rectangle& b) {
    if (is_empty(a)) return b;
    if (is_empty(b)) return a;
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

} // namespace rasterwalk
