#include "mistakes/interpolate.h"

#include <algorithm>

namespace rasterwalk {

LineStep line_step_of_integers(const Fragment& a, const Fragment& b, const LinePart& part) {
    LineStep step = line_step(a, b, part);
    const int steps = std::max(part.count - 1, 1);
    const int x = (b.column - a.column) / steps, y = (b.row - a.row) / steps;
    step.x = static_cast<float>(x);
    step.y = static_cast<float>(y);
    return step;
}

float varying_weight_one(float) {
    return 1.0f;
}

Fragment span_end_times_zinv(const Fragment& end) {
    Fragment again = end;
    again.varyings = end.varyings * end.inv_w;
    return again;
}

} // namespace rasterwalk
