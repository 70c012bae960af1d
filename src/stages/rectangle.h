#pragma once

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

} // namespace rasterwalk
