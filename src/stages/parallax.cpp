#include "stages/parallax.h"

namespace rasterwalk {

glm::vec2 step_divided(float height, const glm::vec3& view) {
    return height * glm::vec2(view) / view.z;
}

glm::vec2 step_limited(float height, const glm::vec3& view) {
    const float side = view.z < 0.0f ? -1.0f : 1.0f;
    return height * side * glm::vec2(view);
}

glm::vec2 step_in_texture(const glm::vec2& step, const UvDirections& uv, const TangentFrame& axes) {
    if (axes.bitangent == glm::vec3(0.0f)) return glm::vec2(0.0f);
    const float v = step.y / glm::dot(uv.along_v, axes.bitangent);
    return {(step.x - v * glm::dot(uv.along_v, axes.tangent)) / glm::dot(uv.along_u, axes.tangent),
            v};
}

} // namespace rasterwalk
