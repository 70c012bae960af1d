#include "mistakes/vertex_shader.h"

#include <glm/vec4.hpp>

#include "stages/stage_table.h"

namespace rasterwalk {

CameraPlace to_camera_by_adding(const glm::vec3& position_world, const Camera& camera,
                                const glm::mat3& rotation, const Stages& stages) {
    const glm::vec3 plus_camera = position_world + camera.position;
    return {plus_camera, stages.rotate_to_camera(plus_camera, rotation)};
}

CameraPlace to_camera_rotated_first(const glm::vec3& position_world, const Camera& camera,
                                    const glm::mat3& rotation, const Stages& stages) {
    const glm::vec3 turned = stages.rotate_to_camera(position_world, rotation);
    return {turned, turned - camera.position};
}

glm::dmat4 view_matrix_with_bottom_row(const glm::dvec3& eye, const glm::dmat3& rotation) {
    glm::dmat4 moved(1.0);
    for (int i = 0; i < 3; ++i)
        moved[i][3] = -eye[i];
    return glm::dmat4(glm::transpose(rotation)) * moved;
}

} // namespace rasterwalk
