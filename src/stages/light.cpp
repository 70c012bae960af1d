#include "stages/light.h"

namespace rasterwalk {

LightTerms reflected_light(const glm::vec3& position_world, const glm::vec3& normal,
                           const glm::vec3& reflectance, const Light& light) {
    constexpr float pi = 3.14159265f;
    LightTerms terms;
    terms.to_light = light.position - position_world;
    terms.distance2 = glm::dot(terms.to_light, terms.to_light);
    const float distance = std::sqrt(terms.distance2);
    terms.sphere_area = 4.0f * pi * terms.distance2;
    if (terms.distance2 > 0.0f) {
        // In this order NaN, from a place too far away for floats, becomes 0.
        terms.cosine = std::max(0.0f, glm::dot(terms.to_light, normal) / distance);
        terms.direct = light.power * (terms.cosine / terms.sphere_area);
    }
    terms.reflected = reflectance * (terms.direct + light.indirect);
    return terms;
}

} // namespace rasterwalk
