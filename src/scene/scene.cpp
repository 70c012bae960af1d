#include "scene/scene.h"

#include <glm/geometric.hpp>

namespace rasterwalk {

glm::vec3 face_normal(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
    const glm::vec3 across = glm::cross(v2 - v0, v1 - v0);
    const float length = glm::length(across);
    return length > 0.0f ? across / length : glm::vec3(0.0f);
}

const std::string& part_name(const Scene& scene, int triangle) {
    return scene.parts[scene.triangles[triangle].part].name;
}

} // namespace rasterwalk
