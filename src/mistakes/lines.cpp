#include "mistakes/lines.h"

#include <algorithm>
#include <cstdint>

namespace rasterwalk {

namespace {

/// A walk by a decision variable: its start value, and what the two steps add to it.
struct DecisionRule {
    std::int64_t begin = 0, after_straight = 0, after_diagonal = 0;
};

void walk(const LineEnd& a, const LineFrame& line, const DecisionRule& rule,
          std::span<LineSample> result, std::span<LineDecision> decisions) {
    int x = static_cast<int>(a.x), y = static_cast<int>(a.y);
    // A mistake can let it grow with every step: to 2^32 on the longest edges.
    std::int64_t d = rule.begin;
    for (std::size_t i = 0; i < result.size(); ++i) {
        LineSample& sample = result[i];
        sample.x = static_cast<float>(x);
        sample.y = static_cast<float>(y);
        sample.fragment.column = x;
        sample.fragment.row = y;
        const bool is_straight = d < 0, is_last = i + 1 == result.size();
        const std::int64_t next = d + (is_straight ? rule.after_straight : rule.after_diagonal);
        if (!decisions.empty()) {
            const PixelStep step = is_straight ? PixelStep::straight : PixelStep::diagonal;
            decisions[i] = {static_cast<double>(d), static_cast<double>(is_last ? d : next),
                            is_last ? PixelStep::none : step};
        }
        x += is_straight ? line.straight_x : line.diagonal_x;
        y += is_straight ? line.straight_y : line.diagonal_y;
        d = next;
    }
}

} // namespace

void line_in_first_octant(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages&,
                          std::span<LineSample> result, std::span<LineDecision> decisions) {
    mix_ends(a, b, part, result);
    const int dx = static_cast<int>(b.x) - static_cast<int>(a.x);
    const int dy = static_cast<int>(b.y) - static_cast<int>(a.y);
    const std::int64_t down = dy, diagonal = down - dx;
    const LineFrame right_and_down{dx, dy, 1, 0, 1, 1, false};
    walk(a, right_and_down, {down + diagonal, 2 * down, 2 * diagonal}, result, decisions);
}

int edge_sample_count_to_the_right(const ScreenVertex& a, const ScreenVertex& b) {
    return std::max(b.column - a.column, 0) + 1;
}

void line_by_wrong_term(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages&,
                        std::span<LineSample> result, std::span<LineDecision> decisions) {
    mix_ends(a, b, part, result);
    const LineFrame line = line_frame(a, b);
    const std::int64_t shorter = line.shorter, longer = line.longer;
    walk(a, line, {2 * shorter - longer, 2 * shorter, -2 * longer}, result, decisions);
}

} // namespace rasterwalk
