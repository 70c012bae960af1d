#include "stages/normal_map.h"

#include <cmath>

namespace rasterwalk {

UvDirections uv_directions(const std::array<Vertex, triangle_corners>& corners) {
    const glm::vec3 side_1 = corners[1].position - corners[0].position,
                    side_2 = corners[2].position - corners[0].position;
    const glm::vec2 uv_1 = corners[1].texcoord - corners[0].texcoord,
                    uv_2 = corners[2].texcoord - corners[0].texcoord;
    const float area = uv_1.x * uv_2.y - uv_2.x * uv_1.y;
    const UvDirections uv{(side_1 * uv_2.y - side_2 * uv_1.y) / area,
                          (side_2 * uv_1.x - side_1 * uv_2.x) / area};
    const bool is_number =
        std::isfinite(glm::dot(uv.along_u, uv.along_u) + glm::dot(uv.along_v, uv.along_v));
    return area != 0.0f && is_number ? uv : UvDirections{};
}

glm::vec3 bent_normal(const glm::vec3& arrow, const TangentFrame& axes) {
    if (axes.bitangent == glm::vec3(0.0f)) return axes.normal;
    const glm::vec3 sum = arrow.x * axes.tangent + arrow.y * axes.bitangent + arrow.z * axes.normal;
    const float length = glm::length(sum);
    return length > 0.0f ? sum / length : axes.normal;
}

std::optional<TangentSpace> world_space(const glm::vec3&, const TangentFrame&) {
    return std::nullopt;
}

SquaredAxes squared_axes(const TangentFrame& axes) {
    SquaredAxes squared;
    squared.lean = glm::dot(axes.tangent, axes.normal);
    squared.width = glm::length(axes.bitangent);
    squared.upright = axes.normal - axes.tangent * squared.lean;
    squared.height = glm::length(squared.upright);
    squared.axes = {axes.tangent, axes.bitangent / squared.width, squared.upright / squared.height};
    return squared;
}

std::optional<TangentSpace> tangent_space(const glm::vec3& arrow, const TangentFrame& axes) {
    if (axes.bitangent == glm::vec3(0.0f)) return std::nullopt;
    const SquaredAxes squared = squared_axes(axes);
    const glm::vec3 normal = squared.arrow(arrow);
    const float length = glm::length(normal);
    if (!(squared.width > 0.0f && squared.height > 0.0f && length > 0.0f)) return std::nullopt;
    return TangentSpace{squared.axes, normal / length};
}

} // namespace rasterwalk
