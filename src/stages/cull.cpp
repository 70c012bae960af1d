#include "stages/cull.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

Rejection back_facing_if(bool is_back) {
    return is_back ? Rejection::back_facing : Rejection::none;
}

} // namespace

float away_from_camera(const ClipVertex& vertex, const VertexRules& rules) {
    glm::vec3 ray = vertex.varyings.position_world - rules.camera.position;
    const float mix = rules.projection.mix;
    if (mix > 0.0f) ray = (1.0f - mix) * ray + mix * camera_rotation(rules.camera)[2];
    return glm::dot(vertex.varyings.normal, ray);
}

float screen_area_sign(std::span<const ClipVertex> corners, const VertexRules& rules) {
    const bool is_divided = rules.space == SceneSpace::pixels;
    const auto row = [is_divided](const ClipVertex& v) {
        const glm::vec4& clip = v.position_clip;
        return glm::vec3(clip.x, clip.y, is_divided ? 1.0f : clip.w);
    };
    const glm::vec3 first = row(corners[0]);
    float sum = 0.0f;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::dot(first, glm::cross(row(corners[i - 1]), row(corners[i])));
    return sum;
}

Rejection cull_by_face_normal(std::span<const ClipVertex> corners, const VertexRules& rules) {
    return back_facing_if(away_from_camera(corners.front(), rules) > 0.0f);
}

Rejection cull_by_screen_area(std::span<const ClipVertex> corners, const VertexRules& rules) {
    const auto is_in_front = [](const ClipVertex& v) { return v.position_clip.w > 0.0f; };
    if (rules.space == SceneSpace::world &&
        !std::all_of(corners.begin(), corners.end(), is_in_front))
        return Rejection::none;
    return back_facing_if(screen_area_sign(corners, rules) < 0.0f);
}

Rejection cull_by_vertex_normals(std::span<const ClipVertex> corners, const VertexRules& rules) {
    const auto is_away = [&](const ClipVertex& v) { return away_from_camera(v, rules) > 0.0f; };
    return back_facing_if(std::all_of(corners.begin(), corners.end(), is_away));
}

} // namespace rasterwalk
