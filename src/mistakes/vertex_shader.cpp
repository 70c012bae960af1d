#include "mistakes/vertex_shader.h"

#include <glm/vec4.hpp>

namespace rasterwalk {

glm::dmat4 view_matrix_with_bottom_row(const glm::dvec3& eye, const glm::dmat3& rotation) {
    glm::dmat4 moved(1.0);
    for (int i = 0; i < 3; ++i)
        moved[i][3] = -eye[i];
    return glm::dmat4(glm::transpose(rotation)) * moved;
}

} // namespace rasterwalk
