#pragma once

// Light: how bright a point of a surface is.
//
// In:  a point, its normal and reflectance, and the lamp.
// Out: the light that leaves toward the eye, red green blue, with every term on the way.
// Picture: the lamp's power spreads over a sphere; what arrives is divided by the sphere's area
//          4 pi r^2 and weakened by the slant of the surface, the cosine between r and n.
//
// The classic mistakes are r not of unit length in the cosine, 1/r^3 for 1/r^2, no 4 pi, and adding
// the indirect light outside the reflectance, so that a black wall glows. Negate r, and only the
// sides that face away from the lamp are lit.
//
// Source: the cosine is Lambert's law, J. H. Lambert, Photometria, 1760: a Lambertian surface looks
// equally bright from everywhere. Worked out at the vertices and interpolated it is Gouraud shading
// (H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers C-20(6),
// 1971); worked out at every pixel it is what B. T. Phong, "Illumination for Computer Generated
// Pictures", Communications of the ACM 18(6), 1975, does, without his highlight (see also J. F.
// Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977).

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// The normal as the light needs it. Light is worked out in world space here, where the normals
/// are. A program that works it out in camera space rotates them there, as directions with w = 0.
/// That changes no angle, and so no light.
inline glm::vec3 light_normal(const glm::vec3& normal, const Camera&) {
    return normal;
}

/// A normal that was interpolated, made unit length again: halfway between two unit vectors that
/// are at an angle it is shorter than 1. A normal of length 0 stays so.
inline glm::vec3 unit_normal(const glm::vec3& interpolated) {
    const float length = std::sqrt(glm::dot(interpolated, interpolated));
    return length > 0.0f ? interpolated / length : glm::vec3(0.0f);
}

// Other laws of fall-off, for programs whose power is really a brightness: the area it is spread
// over at a distance.

/// 1/r^2 without a sphere.
inline float area_without_4pi(float distance2, float) {
    return distance2;
}
/// 1/r: brighter far away than any lamp is, and so often preferred to 1/r^2.
inline float area_of_distance(float, float distance) {
    return distance;
}
/// None: like the sun's.
inline float area_of_one(float, float) {
    return 1.0f;
}

/// Every number on the way to the reflected light, in the order they are worked out.
struct LightTerms {
    glm::vec3 to_light{0.0f};  ///< from the point to the lamp, world units
    float distance2 = 0.0f;    ///< |to_light|^2
    float cosine = 0.0f;       ///< max(r^ . n^, 0); r^ is to_light at unit length
    float sphere_area = 0.0f;  ///< 4 pi distance2
    glm::vec3 direct{0.0f};    ///< D = power * cosine / sphere_area
    glm::vec3 reflected{0.0f}; ///< R = reflectance * (D + indirect)
};

/// R = reflectance * (D + N) with D = P max(r^ . n^, 0) / (4 pi r^2); at the lamp itself D is 0.
/// Defined here so that the pixel shader, which needs only R, does not store the other terms.
inline LightTerms reflected_light(const glm::vec3& position_world, const glm::vec3& normal,
                                  const glm::vec3& reflectance, const Light& light) {
    constexpr float pi = 3.14159265f;
    LightTerms terms;
    terms.to_light = light.position - position_world;
    terms.distance2 = glm::dot(terms.to_light, terms.to_light);
    const float distance = std::sqrt(terms.distance2);
    terms.sphere_area = 4.0f * pi * terms.distance2;
    if (terms.distance2 > 0.0f) {
        // In this order NaN, from a point too far away for float, becomes 0.
        terms.cosine = std::max(0.0f, glm::dot(terms.to_light, normal) / distance);
        terms.direct = light.power * (terms.cosine / terms.sphere_area);
    }
    terms.reflected = reflectance * (terms.direct + light.indirect);
    return terms;
}

} // namespace rasterwalk
