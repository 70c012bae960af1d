#include "mine/functions/row_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "mine/functions/check_parts.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

struct ValueInterval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    bool is_empty() const { return low > high; }
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// The columns of an edge between two rows.
ValueInterval columns_between(const PixelValues& a, const PixelValues& b, double top,
                              double bottom) {
    ValueInterval columns;
    const double dy = b.y - a.y;
    if (dy == 0.0) {
        if (a.y < top || a.y > bottom) return columns;
        columns.add(a.x);
        columns.add(b.x);
        return columns;
    }
    const double t = std::clamp((top - a.y) / dy, 0.0, 1.0);
    const double s = std::clamp((bottom - a.y) / dy, 0.0, 1.0);
    if (std::max(a.y, b.y) < top || std::min(a.y, b.y) > bottom) return columns;
    columns.add(a.x + t * (b.x - a.x));
    columns.add(a.x + s * (b.x - a.x));
    return columns;
}

/// One number at the two ends of an edge.
struct EndNumbers {
    double a = 0.0, b = 0.0;
};

/// A sentence if a number lies outside of the interval.
std::string fault_of(const char* name, const PixelValues& end, double number,
                     const ValueInterval& allowed, double tolerance) {
    if (number >= allowed.low - tolerance && number <= allowed.high + tolerance) return {};
    return fmt::format("{} at {} is {:.6g} where {:.6g} is right.", name, pixel_text(end.x, end.y),
                       number, 0.5 * (allowed.low + allowed.high));
}

} // namespace

bool can_reach(const std::vector<PixelValues>& corners, int row, double left, double right) {
    double left_low = std::numeric_limits<double>::infinity(), left_high = left_low;
    double right_high = -left_low, right_low = right_high;
    double top = corners[0].y, bottom = corners[0].y;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PixelValues& a = corners[i];
        const PixelValues& b = corners[(i + 1) % corners.size()];
        top = std::min(top, a.y);
        bottom = std::max(bottom, a.y);
        const ValueInterval near =
            columns_between(a, b, row - farthest_rounding, row + farthest_rounding);
        if (near.is_empty()) continue;
        left_low = std::min(left_low, near.low - farthest_rounding);
        right_high = std::max(right_high, near.high + farthest_rounding);
        if (row < std::min(a.y, b.y) || row > std::max(a.y, b.y)) continue;
        left_high = std::min(left_high, near.high + farthest_rounding);
        right_low = std::max(right_low, near.low - farthest_rounding);
    }
    if (left > right) return row == top || row == bottom;
    return left >= left_low && left <= left_high && right >= right_low && right <= right_high;
}

std::string value_fault(const std::vector<PixelValues>& corners, const PixelValues& end) {
    ValueInterval zinv;
    ValueInterval places[3], lights[3];
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PixelValues& a = corners[i];
        const PixelValues& b = corners[(i + 1) % corners.size()];
        const double steps = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1.0});
        for (double s = 0.0; s <= steps; ++s) {
            const double t = s / steps;
            const auto between = [t](EndNumbers ends) { return ends.a + t * (ends.b - ends.a); };
            if (!is_close(between({a.x, b.x}), end.x, 2.0) ||
                !is_close(between({a.y, b.y}), end.y, 2.0))
                continue;
            const double weight = between({a.zinv, b.zinv});
            zinv.add(weight);
            for (int c = 0; c < 3; ++c) {
                places[c].add(between({a.place[c], b.place[c]}));
                places[c].add(between({a.place[c] * a.zinv, b.place[c] * b.zinv}) / weight);
                lights[c].add(between({a.light[c], b.light[c]}));
                lights[c].add(between({a.light[c] * a.zinv, b.light[c] * b.zinv}) / weight);
            }
        }
    }
    if (zinv.is_empty()) return {};
    // The values are at most 1: value_tolerance() of a line of 2000 steps.
    const double tolerance = value_tolerance(1.0, 2000);
    std::string fault;
    if (has_field(end, rasterwalk_kit::field_zinv))
        fault = fault_of("1/z", end, end.zinv, zinv, tolerance);
    for (int c = 0; c < 3 && fault.empty(); ++c) {
        if (has_field(end, rasterwalk_kit::field_place))
            fault = fault_of("the position", end, end.place[c], places[c], tolerance);
        if (fault.empty() && has_field(end, rasterwalk_kit::field_light))
            fault = fault_of("the light", end, end.light[c], lights[c], tolerance);
    }
    return fault;
}

} // namespace rasterwalk
