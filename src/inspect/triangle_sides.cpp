#include "inspect/triangle_sides.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rasterwalk {

TriangleSides triangle_sides(const Frame& frame, int triangle) {
    TriangleSides sides;
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const glm::mat3 rotation = camera_rotation(rules.camera);
    const ClipPlanes planes = outer_planes(rules);
    for (int i = 0; i < triangle_corners; ++i) {
        const ClipVertex vertex = frame.stages.vertex_shader(
            frame.scene->corner(triangle, i), rotation, rules, frame.stages, nullptr);
        if (rules.space == SceneSpace::world)
            sides.outcodes[static_cast<std::size_t>(i)] = outcode(vertex, planes);
        if (i == 0) sides.away = away_from_camera(vertex, rules);
    }
    return sides;
}

std::optional<Arrows> arrows_of(std::span<const ScreenVertex> corners) {
    if (corners.size() != static_cast<std::size_t>(triangle_corners)) return std::nullopt;
    const auto arrow_to = [&](std::size_t i) {
        return glm::dvec2(corners[i].column - corners[0].column, corners[i].row - corners[0].row);
    };
    const glm::dvec2 u = arrow_to(1), v = arrow_to(2);
    return Arrows{glm::dot(u, v), u.x * v.y - u.y * v.x};
}

} // namespace rasterwalk
