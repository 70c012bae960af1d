#pragma once

// Mistakes with interpolated normals and highlights, in the slots unit_normal and highlight.

#include "stages/highlight.h"

namespace rasterwalk {

/// B23, in the slot unit_normal: the normal stays as short as interpolation leaves it.
inline glm::vec3 normal_as_interpolated(const glm::vec3& interpolated) {
    return interpolated;
}

/// B50: no check which side the lamp is on. If n . l is below 0, n . h can still be above 0.
constexpr bool shines_unasked(const LightTerms&) {
    return true;
}

/// B51: the sum of two unit vectors, which is up to 2 long. Raised to the exponent, that is a lot.
inline glm::vec3 halfway_vector_too_long(const glm::vec3& to_light, const glm::vec3& to_eye) {
    return to_light + to_eye;
}

/// B50, in the slot highlight.
inline HighlightTerms highlight_unasked(const LightTerms& light, const HighlightPoint& point,
                                        const glm::vec3& lamp_power) {
    return highlight_with<shines_unasked, halfway_vector>(light, point, lamp_power);
}

/// B51, in the slot highlight.
inline HighlightTerms highlight_with_long_half(const LightTerms& light, const HighlightPoint& point,
                                               const glm::vec3& lamp_power) {
    return highlight_with<faces_lamp, halfway_vector_too_long>(light, point, lamp_power);
}

} // namespace rasterwalk
