#include "scene/model.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace rasterwalk {

namespace {

/// The turn in the plane of two axes, from the first toward the second.
glm::dmat4 rotation_in_plane(int from, int toward, double angle) {
    glm::dmat4 matrix(1.0);
    // Each column is the image of an axis.
    matrix[from][from] = std::cos(angle);
    matrix[from][toward] = std::sin(angle);
    matrix[toward][from] = -std::sin(angle);
    matrix[toward][toward] = std::cos(angle);
    return matrix;
}

} // namespace

glm::dmat4 step_matrix(const ModelStep& step) {
    constexpr int x = 0, y = 1, z = 2;
    const auto angle = static_cast<double>(step.amount.x);
    glm::dmat4 matrix(1.0);
    switch (step.kind) {
    case ModelStepKind::translate:
        matrix[3] = glm::dvec4(step.amount, 1.0);
        break;
    case ModelStepKind::scale:
        for (int i = 0; i < 3; ++i)
            matrix[i][i] = static_cast<double>(step.amount[i]);
        break;
    case ModelStepKind::rotate_x:
        return rotation_in_plane(y, z, angle);
    case ModelStepKind::rotate_y:
        return rotation_in_plane(z, x, angle);
    case ModelStepKind::rotate_z:
        return rotation_in_plane(x, y, angle);
    }
    return matrix;
}

glm::dmat4 model_matrix(const std::vector<ModelStep>& steps) {
    glm::dmat4 matrix(1.0);
    for (const ModelStep& step : steps)
        matrix = step_matrix(step) * matrix;
    return matrix;
}

glm::dmat3 normal_matrix(const glm::dmat4& model) {
    const glm::dvec3 a(model[0]), b(model[1]), c(model[2]);
    // The columns of the inverse transpose times the determinant are the cross products of the
    // other two.
    const double side = is_mirrored(model) ? -1.0 : 1.0;
    return {side * glm::cross(b, c), side * glm::cross(c, a), side * glm::cross(a, b)};
}

glm::dvec3 transform_point(const glm::dmat4& matrix, const glm::dvec3& point) {
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

glm::dvec3 transform_direction(const glm::dmat4& matrix, const glm::dvec3& direction) {
    return glm::dvec3(matrix * glm::dvec4(direction, 0.0));
}

bool is_mirrored(const glm::dmat4& model) {
    return glm::determinant(glm::dmat3(model)) < 0.0;
}

} // namespace rasterwalk
