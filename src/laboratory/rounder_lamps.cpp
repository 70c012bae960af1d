#include "laboratory/rounder_lamps.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

namespace {

glm::vec3 rounded_to_parts(const glm::vec3& value, float parts) {
    return glm::round(value * parts) / parts + 0.0f; // no -0
}

} // namespace

std::vector<Light> with_rounder_places(const Light& light, const Light& usual) {
    std::vector<Light> lights;
    for (const glm::vec3& position :
         {light.position, usual.position, rounded_to_parts(light.position, 10.0f),
          rounded_to_parts(light.position, 20.0f), rounded_to_parts(light.position, 100.0f)}) {
        for (const glm::vec3& indirect : {light.indirect, usual.indirect}) {
            lights.push_back(light);
            lights.back().position = position;
            lights.back().indirect = indirect;
        }
    }
    return lights;
}

std::vector<Light> with_rounder_powers(const Light& light, const Light& usual) {
    const float mean = (light.power.x + light.power.y + light.power.z) / 3.0f;
    std::vector<Light> lights{light, light};
    lights.back().power = usual.power;
    for (const float parts : {1.0f, 2.0f, 10.0f}) {
        for (const float steps : {-1.0f, 0.0f, 1.0f}) {
            lights.push_back(light);
            lights.back().power =
                glm::max(rounded_to_parts(glm::vec3(mean + steps / parts), parts), 0.0f);
        }
    }
    return lights;
}

} // namespace rasterwalk
