#pragma once

// Mistakes in the slots of stages/samples.h.

#include "stages/samples.h"

namespace rasterwalk {

/// B100, in the slot resolve: only the mean is clamped. One sample much brighter than 1 makes the
/// whole pixel white, and bright edges stay jagged.
glm::vec3 mean_clamped_late(const SampleColours& colours);

/// B101, in the slot fragment_at_sample: all samples are tested with the depth of the pixel's
/// centre. Outlines are smooth all the same, but where surfaces cross the edge stays jagged; and
/// beyond an outline that depth is extrapolated.
inline const Fragment& fragment_of_centre(const Fragment& at_centre, const Fragment&) {
    return at_centre;
}

} // namespace rasterwalk
