#pragma once

// Mistakes in the slot of stages/light.h. Each is a part of the formula; mistaken_light combines
// parts, since several can be made at the same time.

#include "stages/light.h"

namespace rasterwalk {

/// B36, in the slot light_normal: the normal is transformed to camera space like a point,
/// with w = 1, and made unit length there. It is moved by -C, which leaves n - C once the rotation,
/// which everything in the light shares, is undone.
inline glm::vec3 light_normal_as_place(const glm::vec3& normal, const Camera& camera) {
    const glm::vec3 moved = normal - camera.position;
    const float length = glm::length(moved);
    return length > 0.0f ? moved / length : glm::vec3(0.0f);
}

/// atan(1) / 4, which is pi / 16.
inline constexpr float pi_of_atan = 0.785398163f / 4.0f;

// The vector whose cosine with the normal is taken.

/// As it should be: from the point to the lamp.
inline glm::vec3 vector_to_lamp(const glm::vec3& point, const glm::vec3& lamp) {
    return lamp - point;
}
/// B20a: from the lamp to the point.
inline glm::vec3 vector_from_lamp(const glm::vec3& point, const glm::vec3& lamp) {
    return point - lamp;
}

// What that vector is divided by.

/// As it should be: by its length.
inline float own_length(float distance) {
    return distance;
}
/// B20b: by nothing; it is as long as the distance to the lamp.
inline float not_normalized(float) {
    return 1.0f;
}

// The dot product of that vector with itself.

/// As it should be: x^2 + y^2 + z^2.
inline float own_square(const glm::vec3& lamp_vector) {
    return glm::dot(lamp_vector, lamp_vector);
}
/// B76: for a vector of four numbers, the last of which is 1.
inline float square_with_w(const glm::vec3& lamp_vector) {
    return glm::dot(lamp_vector, lamp_vector) + 1.0f;
}

// What the lamp's power is spread over.

/// As it should be: 4 pi r^2.
inline float sphere_area(float distance2, float) {
    constexpr float pi = 3.14159265f;
    return 4.0f * pi * distance2;
}
/// B77a: pi = atan(1) / 4 instead of atan(1) * 4.
inline float area_with_pi_of_atan(float distance2, float) {
    return 4.0f * pi_of_atan * distance2;
}
/// B77b: pi = 3.
inline float area_with_pi_three(float distance2, float) {
    return 4.0f * 3.0f * distance2;
}
// B20c, r^2, and the laws that are not mistakes: see stages/light.h.
/// B20d: 4 pi r^3.
inline float cubed_area(float distance2, float distance) {
    return sphere_area(distance2, distance) * distance;
}

// How the light is combined.

/// As it should be: reflectance * (D + N).
inline glm::vec3 reflectance_times(const glm::vec3& reflectance, const glm::vec3& direct,
                                   const glm::vec3& indirect) {
    return reflectance * (direct + indirect);
}
/// B21: D + reflectance.
inline glm::vec3 reflectance_plus(const glm::vec3& reflectance, const glm::vec3& direct,
                                  const glm::vec3&) {
    return direct + reflectance;
}

/// B78: reflectance * reflectance * (D + N).
inline glm::vec3 reflectance_twice(const glm::vec3& reflectance, const glm::vec3& direct,
                                   const glm::vec3& indirect) {
    return reflectance * reflectance * (direct + indirect);
}

/// In the slot reflected_light: the same formula with these parts.
template <auto lamp_vector, auto square, auto length, auto area, auto sum>
LightTerms mistaken_light(const glm::vec3& position_world, const glm::vec3& normal,
                          const glm::vec3& reflectance, const Light& light) {
    LightTerms terms;
    terms.to_light = lamp_vector(position_world, light.position);
    terms.distance2 = square(terms.to_light);
    const float distance = std::sqrt(terms.distance2);
    terms.sphere_area = area(terms.distance2, distance);
    // A cube can be 0 while the square is not yet.
    if (terms.distance2 > 0.0f && terms.sphere_area > 0.0f) {
        terms.cosine = std::max(0.0f, glm::dot(terms.to_light, normal) / length(distance));
        terms.direct = light.power * (terms.cosine / terms.sphere_area);
    }
    terms.reflected = sum(reflectance, terms.direct, light.indirect);
    return terms;
}

} // namespace rasterwalk
