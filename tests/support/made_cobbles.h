#pragma once

// A pavement of cobbles, computed: domes on a jittered grid, with sand in between.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "support/painted.h"

namespace rasterwalk::test {

inline constexpr int cobbles_side = 64, cobbles_across = 4;

/// Three numbers, hashed: 0 to 255.
inline int hashed(int a, int b, int c) {
    auto h = static_cast<std::uint32_t>(a * 73856093 ^ b * 19349663 ^ c * 83492791);
    h ^= h >> 13;
    h *= 0x5bd1e995u;
    h ^= h >> 15;
    return static_cast<int>(h & 255u);
}

/// The stone that a texel belongs to, and how far the texel is from the next one, texels.
struct Cobble {
    int column = 0, row = 0;
    double border = 0.0;
};

/// The texture repeats, so the stones do.
inline Cobble cobble_at(int x, int y) {
    constexpr double step = static_cast<double>(cobbles_side) / cobbles_across;
    const int near_column = static_cast<int>(x / step), near_row = static_cast<int>(y / step);
    double best = 1e9, second = 1e9;
    Cobble found;
    for (int row = near_row - 2; row <= near_row + 2; ++row) {
        for (int column = near_column - 2; column <= near_column + 2; ++column) {
            const int c = (column + 2 * cobbles_across) % cobbles_across,
                      r = (row + 2 * cobbles_across) % cobbles_across;
            const double shift = row % 2 == 0 ? 0.25 : 0.75;
            const double cx = (column + shift + (hashed(c, r, 1) - 128) / 800.0) * step,
                         cy = (row + 0.5 + (hashed(c, r, 2) - 128) / 900.0) * step;
            const double dx = x + 0.5 - cx, dy = y + 0.5 - cy;
            const double distance = std::sqrt(dx * dx + dy * dy);
            if (distance < best) {
                second = best;
                best = distance;
                found.column = c;
                found.row = r;
            } else if (distance < second) {
                second = distance;
            }
        }
    }
    found.border = 0.5 * (second - best);
    return found;
}

/// 0 in the sand to 1 on top of a stone.
inline double cobble_height(int x, int y) {
    const double part = std::min(std::max((cobble_at(x, y).border - 0.4) / 4.6, 0.0), 1.0);
    return std::sqrt(1.0 - (1.0 - part) * (1.0 - part));
}

inline Image cobble_heights() {
    return painted(cobbles_side, cobbles_side, [](int x, int y) {
        const int grey = static_cast<int>(std::floor(255.0 * cobble_height(x, y) + 0.5));
        return Rgb{grey, grey, grey};
    });
}

inline Image cobbles() {
    return painted(cobbles_side, cobbles_side, [](int x, int y) {
        const int grain = hashed(x, y, 3) % 14;
        if (cobble_height(x, y) < 0.3) return Rgb{92 + grain, 80 + grain, 62 + grain};
        const Cobble stone = cobble_at(x, y);
        const int shade = hashed(stone.column, stone.row, 4) % 60,
                  warm = hashed(stone.column, stone.row, 5) % 26;
        return Rgb{126 + shade + warm + grain, 124 + shade + warm / 3 + grain, 122 + shade + grain};
    });
}

} // namespace rasterwalk::test
