#include "stages/project.h"

#include <cmath>

#include "stages/orthographic.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

ProjectedVertex rejected(Rejection rejection) {
    ProjectedVertex vertex;
    vertex.rejection = rejection;
    return vertex;
}

/// Written so that NaN, which fails every comparison, is too far out as well.
bool is_too_far_out(const glm::vec2& projected, float inv_w) {
    return !(std::abs(projected.x) <= max_pixel_distance &&
             std::abs(projected.y) <= max_pixel_distance && std::isfinite(inv_w));
}

/// One coordinate as a whole pixel, counted from the picture's border.
/// @param projected pixels from the middle of the picture
int snap(float projected, int middle, VertexRounding rounding) {
    switch (rounding) {
    case VertexRounding::truncate:
        return to_pixel(projected, Rounding::truncate) + middle;
    case VertexRounding::floor:
        return to_pixel(projected, Rounding::floor) + middle;
    case VertexRounding::round:
        return to_pixel(projected, Rounding::round) + middle;
    case VertexRounding::truncate_sum:
        return to_pixel(projected + static_cast<float>(middle), Rounding::truncate);
    }
    return middle;
}

} // namespace

bool is_in_front(const glm::vec4& clip, const VertexRules& rules) {
    return has_positive_w(clip, rules) &&
           (rules.projection.mix == 0.0f || camera_depth(clip, rules) > 0.0f);
}

glm::ivec2 viewport_middle(const VertexRules& rules) {
    if (rules.space == SceneSpace::pixels) return {0, 0};
    return {rules.viewport.width / 2, rules.viewport.height / 2};
}

ScreenPlace snap_to_pixel(const glm::vec2& projected, glm::ivec2 middle, const VertexRules& rules) {
    ScreenPlace place;
    place.position = projected + glm::vec2(middle);
    // A position given as a pixel is that pixel's centre.
    if (rules.space == SceneSpace::pixels) place.position += 0.5f;
    place.pixel = {snap(projected.x, middle.x, rules.rounding),
                   snap(projected.y, middle.y, rules.rounding)};
    return place;
}

ProjectedVertex project(const ClipVertex& vertex, const VertexRules& rules, const Stages& stages,
                        VertexSpaces* spaces) {
    const glm::vec4& clip = vertex.position_clip;
    if (!std::isfinite(clip.w)) return rejected(Rejection::not_finite);
    if (!stages.is_in_front(clip, rules)) return rejected(Rejection::behind_camera);
    const float inv_w = 1.0f / clip.w;
    const glm::vec2 projected = rules.space == SceneSpace::world
                                    ? stages.perspective_divide(clip, inv_w)
                                    : glm::vec2(clip.x, clip.y);
    if (spaces != nullptr) spaces->add("projected", {projected, 0.0f});
    if (is_too_far_out(projected, inv_w)) return rejected(Rejection::too_far_out);
    const glm::ivec2 middle = stages.viewport_middle(rules);
    const ScreenPlace place = stages.snap_to_pixel(projected, middle, rules);
    ProjectedVertex result;
    result.has_pixel = true;
    result.pixel.position = place.position;
    result.pixel.column = place.pixel.x;
    result.pixel.row = place.pixel.y;
    result.pixel.depth = clip.z * inv_w;
    result.pixel.inv_w = inv_w;
    result.pixel.z = camera_depth(clip, rules);
    result.pixel.varyings = vertex.varyings * stages.varying_weight(inv_w, stages);
    return result;
}

ShadedVertex shade_vertex(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                          const Stages& stages) {
    ShadedVertex shaded;
    const ClipVertex clip = stages.vertex_shader(vertex, rotation, rules, stages, &shaded.spaces);
    const ProjectedVertex projected = stages.project(clip, rules, stages, &shaded.spaces);
    shaded.position_clip = clip.position_clip;
    shaded.pixel = projected.pixel;
    shaded.rejection = projected.rejection;
    shaded.has_pixel = projected.has_pixel;
    return shaded;
}

} // namespace rasterwalk
