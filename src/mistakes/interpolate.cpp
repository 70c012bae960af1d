#include "mistakes/interpolate.h"

#include <algorithm>

namespace rasterwalk {

LineStep line_step_of_integers(const LineEnd& a, const LineEnd& b, const LinePart& part) {
    LineStep step = line_step(a, b, part);
    const int steps = std::max(part.count - 1, 1);
    const int x = static_cast<int>(b.x - a.x) / steps, y = static_cast<int>(b.y - a.y) / steps;
    step.x = static_cast<float>(x);
    step.y = static_cast<float>(y);
    return step;
}

float varying_weight_one(float) {
    return 1.0f;
}

RowEnd span_end_times_zinv(const RowEnd& end) {
    RowEnd again = end;
    again.varyings = end.varyings * end.inv_w;
    return again;
}

} // namespace rasterwalk
