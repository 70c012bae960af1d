#include "mistakes/interpolate.h"

#include <algorithm>

#include "stages/stage_table.h"

namespace rasterwalk {

LineStep line_step_of_integers(const LineEnd& a, const LineEnd& b, const LinePart& part) {
    LineStep step = line_step(a, b, part);
    const int steps = std::max(part.count - 1, 1);
    const int x = static_cast<int>(b.x - a.x) / steps, y = static_cast<int>(b.y - a.y) / steps;
    step.x = static_cast<float>(x);
    step.y = static_cast<float>(y);
    return step;
}

LineStep line_step_by_samples(const LineEnd& a, const LineEnd& b, const LinePart& part) {
    LinePart longer = part;
    ++longer.count;
    return line_step(a, b, longer);
}

void row_fragments_with_falling_zinv(const Stages& stages, const Row& row, int first,
                                     VaryingSet carried, std::span<LineSample> result) {
    constexpr auto turn = [](LineStep& step) {
        step.depth = -step.depth;
        step.inv_w = -step.inv_w;
    };
    row_fragments_with<turn>(stages, row, first, carried, result);
}

float recovery_weight_squared(float zinv, const Stages&) {
    return zinv * zinv;
}

float varying_weight_one(float, const Stages&) {
    return 1.0f;
}

RowEnd span_end_times_zinv(const RowEnd& end) {
    RowEnd again = end;
    again.varyings = end.varyings * end.inv_w;
    return again;
}

} // namespace rasterwalk
