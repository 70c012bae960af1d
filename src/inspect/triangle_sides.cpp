#include "inspect/triangle_sides.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

/// Where the plane cuts the edge between two vertices, from the one inside; none if it does not.
std::optional<float> cut_at(const glm::vec4& plane, const ClipVertex& a, const ClipVertex& b) {
    const float d_a = inner_distance(plane, a), d_b = inner_distance(plane, b);
    if ((d_a >= 0.0f) == (d_b >= 0.0f)) return std::nullopt;
    return std::max(d_a, d_b) / std::abs(d_a - d_b);
}

} // namespace

TriangleSides triangle_sides(const Frame& frame, int triangle) {
    TriangleSides sides;
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const glm::mat3 rotation = camera_rotation(rules.camera);
    const ClipPlanes planes = outer_planes(rules);
    std::array<ClipVertex, triangle_corners> vertices;
    for (int i = 0; i < triangle_corners; ++i) {
        ClipVertex& vertex = vertices[static_cast<std::size_t>(i)];
        vertex = frame.stages.vertex_shader(frame.scene->corner(triangle, i), rotation, rules,
                                            frame.stages, nullptr);
        if (rules.space == SceneSpace::world)
            sides.outcodes[static_cast<std::size_t>(i)] = outcode(vertex, planes);
    }
    sides.away = away_from_camera(vertices.front(), rules);
    for (std::size_t i = 0; i < vertices.size() && !sides.near_t; ++i) {
        if (rules.space == SceneSpace::world)
            sides.near_t = cut_at(planes.front(), vertices[i], vertices[(i + 1) % vertices.size()]);
    }
    return sides;
}

std::optional<ArrowProducts> arrows_of(std::span<const ScreenVertex> corners) {
    if (corners.size() != static_cast<std::size_t>(triangle_corners)) return std::nullopt;
    const auto arrow_to = [&](std::size_t i) {
        return glm::dvec2(corners[i].column - corners[0].column, corners[i].row - corners[0].row);
    };
    const glm::dvec2 u = arrow_to(1), v = arrow_to(2);
    return ArrowProducts{glm::dot(u, v), u.x * v.y - u.y * v.x};
}

} // namespace rasterwalk
