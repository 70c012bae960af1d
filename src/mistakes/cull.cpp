#include "mistakes/cull.h"

#include <glm/geometric.hpp>

namespace rasterwalk {

Rejection cull_by_view_axis(std::span<const ClipVertex> corners, const VertexRules& rules) {
    // Of a row vector times R, z is the product with the last column.
    const glm::vec3 forward = camera_rotation(rules.camera)[2];
    const bool is_back = glm::dot(corners.front().varyings.normal, forward) > 0.0f;
    return is_back ? Rejection::back_facing : Rejection::none;
}

} // namespace rasterwalk
