#pragma once

// Mistakes in the slot of stages/blend.h.

#include <glm/vec3.hpp>

namespace rasterwalk {

/// B63, in the slot blend: the two shares are swapped. At alpha 1/2 it cannot be seen.
inline glm::vec3 blend_swapped(const glm::vec3& fragment, float alpha, const glm::vec3& pixel) {
    return fragment * (1.0f - alpha) + pixel * alpha;
}

} // namespace rasterwalk
