#pragma once

// The highlight: the mirror image of the lamp in a surface that is not quite a mirror.
//
// In:  the light's terms at a point, the normal, the direction to the eye, and how the surface
//      shines.
// Out: the light of the highlight, red green blue, with every term on the way.
// Picture: h points halfway between lamp and eye. If the surface were tilted so that its normal is
//          h, you would see the lamp in it as in a mirror; the farther n is from h, the less of it
//          you see. The exponent says how fast that goes.
//
// The classic mistakes are no test of n . l, so that a back shines through; h not made unit length,
// so that the exponent works on a number up to 2; and an interpolated normal that is too short, so
// that a high exponent leaves next to nothing halfway between the vertices.
//
// Source: J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH
// 1977, after B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the
// ACM 18(6), 1975.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "stages/light.h"

namespace rasterwalk {

/// Every number on the way to the highlight. All zero where there is none: the lamp is behind the
/// surface, or there is no direction to it or to the eye.
struct HighlightTerms {
    glm::vec3 to_light{0.0f};  ///< l, of unit length
    glm::vec3 to_eye{0.0f};    ///< v, of unit length
    glm::vec3 half{0.0f};      ///< h = (l + v) / |l + v|
    float n_dot_h = 0.0f;      ///< max(n . h, 0)
    float power = 0.0f;        ///< n_dot_h to the power of the exponent
    glm::vec3 reflected{0.0f}; ///< S = specular * lamp's power * (power / area)
};

/// What the highlight is worked out from, in addition to the light's terms.
struct HighlightPoint {
    glm::vec3 normal{0.0f}; ///< as the light has it
    glm::vec3 to_eye{0.0f}; ///< from the point toward the eye, any length
    Shine shine;
};

/// The exponent of a highlight: the light's, if it gives one for all materials.
constexpr float exponent_of(const Shine& shine, const Light& light) {
    return light.exponent > 0.0f ? light.exponent : shine.exponent;
}

/// Is the lamp on the side to which the normal points?
constexpr bool faces_lamp(const LightTerms& terms) {
    return terms.cosine > 0.0f;
}
/// h of two directions of unit length.
inline glm::vec3 halfway_vector(const glm::vec3& to_light, const glm::vec3& to_eye) {
    const glm::vec3 sum = to_light + to_eye;
    const float length = std::sqrt(glm::dot(sum, sum));
    return length > 0.0f ? sum / length : glm::vec3(0.0f);
}

/// The highlight with these parts; the right ones are faces_lamp and halfway_vector.
template <auto shines, auto half_vector>
HighlightTerms highlight_with(const LightTerms& light, const HighlightPoint& point,
                              const glm::vec3& lamp_power) {
    HighlightTerms terms;
    const float eye_distance2 = glm::dot(point.to_eye, point.to_eye);
    if (!shines(light) || !(light.distance2 > 0.0f) || !(light.sphere_area > 0.0f) ||
        !(eye_distance2 > 0.0f))
        return terms;
    terms.to_light = light.to_light / std::sqrt(light.distance2);
    terms.to_eye = point.to_eye / std::sqrt(eye_distance2);
    terms.half = half_vector(terms.to_light, terms.to_eye);
    // In this order NaN becomes 0.
    terms.n_dot_h = std::max(0.0f, glm::dot(point.normal, terms.half));
    terms.power = std::pow(terms.n_dot_h, point.shine.exponent);
    terms.reflected = point.shine.specular * (lamp_power * (terms.power / light.sphere_area));
    return terms;
}

/// S = k P max(n . h, 0)^e / area, only where n . l > 0.
inline HighlightTerms highlight(const LightTerms& light, const HighlightPoint& point,
                                const glm::vec3& lamp_power) {
    return highlight_with<faces_lamp, halfway_vector>(light, point, lamp_power);
}

} // namespace rasterwalk
