#pragma once

// The right results of interpolate and the row table, computed in a different way: sums and
// products of floats in double, where they are exact, and fractions as whole numbers.

#include <climits>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <vector>

#include "stages/polygon_corners.h"
#include "support/walks.h"

namespace rasterwalk::test {

/// The whole number k for which `numerator / denominator` rounds to it, found by asking which k
/// meets the definition; denominator > 0.
inline int round_fraction(std::int64_t numerator, std::int64_t denominator, Rounding rounding) {
    const auto meets = [&](std::int64_t k) {
        switch (rounding) {
        case Rounding::truncate:
            return numerator >= 0
                       ? k * denominator <= numerator && numerator < (k + 1) * denominator
                       : (k - 1) * denominator < numerator && numerator <= k * denominator;
        case Rounding::floor:
            return k * denominator <= numerator && numerator < (k + 1) * denominator;
        case Rounding::round: // k - 1/2 <= n/d < k + 1/2
            return (2 * k - 1) * denominator <= 2 * numerator &&
                   2 * numerator < (2 * k + 1) * denominator;
        }
        return false;
    };
    const std::int64_t near = numerator / denominator;
    for (std::int64_t k = near - 2; k <= near + 2; ++k) {
        if (meets(k)) return static_cast<int>(k);
    }
    return INT_MIN;
}

/// The whole number to which a float of less than 2^31 rounds. Double holds all of it exactly.
inline int round_float(float value, Rounding rounding) {
    const double v = value;
    const auto meets = [&](double k) {
        switch (rounding) {
        case Rounding::truncate:
            return v >= 0.0 ? k <= v && v < k + 1.0 : k - 1.0 < v && v <= k;
        case Rounding::floor:
            return k <= v && v < k + 1.0;
        case Rounding::round:
            return k - 0.5 <= v && v < k + 0.5;
        }
        return false;
    };
    const auto near = static_cast<std::int64_t>(v);
    for (std::int64_t k = near - 2; k <= near + 2; ++k) {
        if (meets(static_cast<double>(k))) return static_cast<int>(k);
    }
    return INT_MIN;
}

/// One coordinate of sample i of `count`, before rounding, as the float walks have it.
inline float walked(float a, float b, int i, int count, LineWalk walk) {
    // A float sum, product or quotient rounded from double is rounded correctly: double has more
    // than twice the digits.
    const double n = count > 1 ? count - 1 : 1;
    const auto difference = static_cast<float>(static_cast<double>(b) - a);
    const auto step = static_cast<float>(difference / n);
    if (walk == LineWalk::multiply) {
        const auto way = static_cast<float>(static_cast<double>(i) * step);
        return static_cast<float>(static_cast<double>(a) + way);
    }
    float current = a;
    for (int k = 0; k < i; ++k)
        current = static_cast<float>(static_cast<double>(current) + step);
    return current;
}

struct Place {
    int column = 0, row = 0;
    friend bool operator==(const Place&, const Place&) = default;
};

/// The pixels of a line of `count` samples.
inline std::vector<Place> line_places(const ScreenVertex& a, const ScreenVertex& b, int count,
                                      const LineRules& rules) {
    std::vector<Place> places;
    const std::int64_t n = count > 1 ? count - 1 : 1;
    for (int i = 0; i < count; ++i) {
        if (rules.walk == LineWalk::exact) {
            const auto exact = [&](int from, int to) {
                return round_fraction(from * n + static_cast<std::int64_t>(to - from) * i, n,
                                      rules.rounding);
            };
            places.push_back({exact(a.column, b.column), exact(a.row, b.row)});
        } else {
            const auto float_walk = [&](int from, int to) {
                return round_float(
                    walked(static_cast<float>(from), static_cast<float>(to), i, count, rules.walk),
                    rules.rounding);
            };
            places.push_back({float_walk(a.column, b.column), float_walk(a.row, b.row)});
        }
    }
    return places;
}

/// Both ends of a row, and which sample wrote them: vertex or edge number and sample of the edge.
struct RowEnds {
    int left = INT_MAX, right = -INT_MAX;
    int left_edge = -1, left_sample = -1, right_edge = -1, right_sample = -1;
};

/// The row table of a polygon by its definition; `outside` counts samples beyond its rows.
inline std::map<int, RowEnds> row_table(PolygonCorners vertices, const WalkRules& rules,
                                        int& outside) {
    std::map<int, RowEnds> rows;
    int top = INT_MAX, bottom = INT_MIN;
    for (const ScreenVertex& vertex : vertices) {
        top = vertex.row < top ? vertex.row : top;
        bottom = vertex.row > bottom ? vertex.row : bottom;
    }
    for (int row = top; row <= bottom; ++row)
        rows[row] = {};
    outside = 0;
    for (std::size_t e = 0; e < vertices.size(); ++e) {
        const ScreenVertex& a = vertices[e];
        const ScreenVertex& b = vertices[(e + 1) % vertices.size()];
        const int dx = std::abs(b.column - a.column), dy = std::abs(b.row - a.row);
        const int count = 1 + (rules.samples == EdgeSamples::rows || dy > dx ? dy : dx);
        const std::vector<Place> places = line_places(a, b, count, rules.line);
        for (int s = 0; s < count; ++s) {
            const Place place = places[static_cast<std::size_t>(s)];
            const auto found = rows.find(place.row);
            if (found == rows.end()) {
                ++outside;
                continue;
            }
            RowEnds& ends = found->second;
            if (place.column < ends.left) {
                ends.left = place.column;
                ends.left_edge = static_cast<int>(e);
                ends.left_sample = s;
            }
            if (place.column > ends.right) {
                ends.right = place.column;
                ends.right_edge = static_cast<int>(e);
                ends.right_sample = s;
            }
        }
    }
    return rows;
}

} // namespace rasterwalk::test
