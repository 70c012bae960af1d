#pragma once

// Mistakes in the slots of stages/interpolate.h and stages/spans.h, and in those of the weights by
// which varyings are carried.

#include "stages/interpolate.h"
#include "stages/spans.h"

namespace rasterwalk {

/// B11, in the slot line_step: the step of the position is divided as int by int, which drops its
/// fraction. The other values keep their right steps.
LineStep line_step_of_integers(const LineEnd& a, const LineEnd& b, const LinePart& part);

/// B92, in the slot line_step: divided by the number of samples, although there is one step fewer.
/// The last sample falls short of the end by one step.
LineStep line_step_by_samples(const LineEnd& a, const LineEnd& b, const LinePart& part);

/// B89, in the slot row_fragments: along a row 1/z changes by the right amount, in the wrong
/// direction.
void row_fragments_with_falling_zinv(const Stages& stages, const Row& row, int first,
                                     VaryingSet carried, std::span<LineSample> result);

/// B3, in the slots varying_weight and recovery_weight: q itself is interpolated, which is wrong
/// except at the vertices. B86, in the slot recovery_weight alone: q/z is used as q.
float varying_weight_one(float zinv, const Stages&);

/// B87, in the slot recovery_weight: q/z is divided by 1/z twice, which leaves q z.
float recovery_weight_squared(float zinv, const Stages&);

/// B4, in the slot span_end: the varyings, already divided by z at the vertices, are multiplied by
/// 1/z a second time.
RowEnd span_end_times_zinv(const RowEnd& end);

} // namespace rasterwalk
