#include "inspect/triangle_sides.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rasterwalk {

namespace {

/// Where the plane cuts the edge between two vertices, from the inner one; none if it does not.
std::optional<float> cut_at(const glm::vec4& plane, const ClipVertex& a, const ClipVertex& b) {
    const float d_a = inner_distance(plane, a), d_b = inner_distance(plane, b);
    if ((d_a >= 0.0f) == (d_b >= 0.0f)) return std::nullopt;
    return d_a >= 0.0f ? cut_place(d_a, d_b) : cut_place(d_b, d_a);
}

/// Keeps t of the first edge that the near plane cuts.
class NearCut : public ClipSink {
  public:
    void clip_step(const ClipStep& step) override {
        if (step.is_cut && step.plane == ClipPlane::near && !t) t = step.t;
    }
    std::optional<float> t;
};

} // namespace

TriangleSides triangle_sides(const Frame& frame, int triangle) {
    TriangleSides sides;
    const VertexRules rules = vertex_rules(frame.settings, frame.scene->space);
    const auto corners = frame.given_clip_vertices(triangle);
    sides.away = away_from_camera(as_one_face(corners), sight_rays(rules));
    if (rules.space == SceneSpace::pixels) return sides;
    sides.codes = triangle_codes(corners, outer_planes(rules));
    NearCut drawn;
    replay_clipping(frame, triangle, drawn);
    sides.near_t = drawn.t;
    const glm::vec4& near = sides.codes.planes.front();
    for (std::size_t i = 0; i < corners.size() && !sides.near_t; ++i)
        sides.near_t = cut_at(near, corners[i], corners[(i + 1) % corners.size()]);
    return sides;
}

std::optional<ArrowProducts> arrows_of(PolygonCorners corners) {
    if (corners.size() != static_cast<std::size_t>(triangle_corners)) return std::nullopt;
    const auto arrow_to = [&](std::size_t i) {
        return glm::dvec2(corners[i].column - corners[0].column, corners[i].row - corners[0].row);
    };
    const glm::dvec2 u = arrow_to(1), v = arrow_to(2);
    return ArrowProducts{glm::dot(u, v), u.x * v.y - u.y * v.x, glm::length(u)};
}

} // namespace rasterwalk
