#pragma once

// Light: how bright a point of a surface is.
//
// In:  a place, its normal and reflectance, and the lamp.
// Out: the light that leaves toward the eye, red green blue, with every term on the way.
// Picture: the lamp's power spreads over a sphere; what arrives is divided by the sphere's area
//          4 pi r^2 and weakened by the slant of the surface, the cosine between r and n.
//
// The classic mistakes: r not of unit length in the cosine, 1/r^3 for 1/r^2, no 4 pi, and adding
// the indirect light outside the reflectance, so that a black wall glows. Turn r round, and only
// the sides that face away from the lamp are lit.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// The vector of whose slant the cosine is taken.
enum class LightDirection : std::uint8_t {
    to_light,       ///< from the point to the lamp, at unit length
    from_light,     ///< from the lamp to the point: mistake B20
    not_normalized, ///< to the lamp, but as long as the way there: mistake B20
};

/// Over what the lamp's power is spread.
enum class LightFalloff : std::uint8_t {
    sphere, ///< 4 pi r^2
    no_4pi, ///< r^2: mistake B20
    cubed,  ///< 4 pi r^3: mistake B20
};

/// How direct light, indirect light and reflectance are put together.
enum class LightSum : std::uint8_t {
    reflectance_times, ///< reflectance * (D + N)
    reflectance_plus,  ///< D + reflectance: mistake B21
};

/// The rules by which light is computed; as they stand, the lab's.
struct LightRules {
    LightDirection direction = LightDirection::to_light;
    LightFalloff falloff = LightFalloff::sphere;
    LightSum sum = LightSum::reflectance_times;

    friend bool operator==(const LightRules&, const LightRules&) = default;
};

/// Every number on the way to the reflected light, in the order in which they arise.
struct LightTerms {
    glm::vec3 to_light{0.0f};  ///< from the point to the lamp, world units; or the other way round
    float distance2 = 0.0f;    ///< |to_light|^2
    float cosine = 0.0f;       ///< max(r^ . n^, 0); r^ is to_light at unit length
    float sphere_area = 0.0f;  ///< 4 pi distance2, or what another falloff puts in its place
    glm::vec3 direct{0.0f};    ///< D = power * cosine / sphere_area
    glm::vec3 reflected{0.0f}; ///< R = reflectance * (D + indirect)
};

/// R = reflectance * (D + N) with D = P max(r^ . n^, 0) / (4 pi r^2); at the lamp itself D is 0.
/// Defined here, so that the compiler leaves out of the pixel shader the terms that it does not
/// use.
inline LightTerms reflected_light(const glm::vec3& position_world, const glm::vec3& normal,
                                  const glm::vec3& reflectance, const Light& light,
                                  const LightRules& rules = {}) {
    constexpr float pi = 3.14159265f;
    LightTerms terms;
    terms.to_light = rules.direction == LightDirection::from_light
                         ? position_world - light.position
                         : light.position - position_world;
    terms.distance2 = glm::dot(terms.to_light, terms.to_light);
    const float distance = std::sqrt(terms.distance2);
    terms.sphere_area =
        rules.falloff == LightFalloff::no_4pi ? terms.distance2 : 4.0f * pi * terms.distance2;
    if (rules.falloff == LightFalloff::cubed) terms.sphere_area *= distance;
    // A cube may be 0 where the square is not yet.
    const bool has_area = rules.falloff != LightFalloff::cubed || terms.sphere_area > 0.0f;
    if (terms.distance2 > 0.0f && has_area) {
        const float length = rules.direction == LightDirection::not_normalized ? 1.0f : distance;
        // In this order NaN, from a place too far away for floats, becomes 0.
        terms.cosine = std::max(0.0f, glm::dot(terms.to_light, normal) / length);
        terms.direct = light.power * (terms.cosine / terms.sphere_area);
    }
    terms.reflected = rules.sum == LightSum::reflectance_times
                          ? reflectance * (terms.direct + light.indirect)
                          : terms.direct + reflectance;
    return terms;
}

} // namespace rasterwalk
