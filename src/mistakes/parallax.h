#pragma once

// The mistake with parallax mapping, in the slot parallax_step.

#include "stages/parallax.h"

namespace rasterwalk {

/// B99: the step is subtracted, as for a map of depths, although the map has heights.
/// @tparam right the step that would be added
template <auto right>
glm::vec2 step_subtracted(float height, const glm::vec3& view) {
    return -1.0f * right(height, view);
}

} // namespace rasterwalk
