#pragma once

// Mistakes in the slots of stages/interpolate.h.

#include "stages/interpolate.h"

namespace rasterwalk {

/// B11, in the slot line_step: the step of the place is divided as int by int, which drops its
/// fraction. The other values keep their right steps.
LineStep line_step_of_integers(const LineEnd& a, const LineEnd& b, const LinePart& part);

/// B3, in the slot varying_weight: q itself is interpolated, which is wrong except at the vertices.
float varying_weight_one(float zinv);

/// B4, in the slot span_end: the varyings, which the vertices have divided by z already, are
/// multiplied by 1/z a second time.
RowEnd span_end_times_zinv(const RowEnd& end);

} // namespace rasterwalk
