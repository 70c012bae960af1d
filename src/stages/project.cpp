#include "stages/project.h"

#include <algorithm>
#include <cmath>

#include "stages/stage_table.h"

namespace rasterwalk {

ProjectedVertex project(const ClipVertex& vertex, const VertexRules& rules, const Stages& stages,
                        VertexSpaces* spaces) {
    ProjectedVertex result;
    const glm::vec4& clip = vertex.position_clip;
    if (!std::isfinite(clip.w)) {
        result.rejection = Rejection::not_finite;
        return result;
    }
    if (!(clip.w > 0.0f) && rules.behind_camera != BehindCamera::drawn) {
        result.rejection = Rejection::behind_camera;
        return result;
    }
    const float inv_w = 1.0f / clip.w;
    glm::vec2 projected(clip.x, clip.y);
    int middle_column = 0, middle_row = 0;
    if (rules.space == SceneSpace::world) {
        projected = projected * inv_w;
        middle_column = rules.viewport.width / 2;
        middle_row = rules.viewport.height / 2;
    }
    if (spaces != nullptr) spaces->add("projected", {projected, 0.0f});
    // Written so that NaN, which no comparison admits, is caught as well.
    if (!(std::abs(projected.x) <= max_pixel_distance &&
          std::abs(projected.y) <= max_pixel_distance && std::isfinite(inv_w))) {
        result.rejection = Rejection::too_far_out;
        return result;
    }
    Fragment& pixel = result.pixel;
    result.has_pixel = true;
    pixel.column = to_pixel(projected.x, rules.rounding) + middle_column;
    pixel.row = to_pixel(projected.y, rules.rounding) + middle_row;
    if (rules.outside_picture == OutsidePicture::clamped) {
        pixel.column = std::clamp(pixel.column, 0, rules.viewport.width - 1);
        pixel.row = std::clamp(pixel.row, 0, rules.viewport.height - 1);
    }
    if (rules.behind_camera == BehindCamera::mark_minus_one && pixel.column == -1) {
        result.rejection = Rejection::taken_for_behind;
    }
    pixel.depth = clip.z * inv_w;
    pixel.inv_w = inv_w;
    pixel.z = clip.w;
    pixel.varyings = vertex.varyings * stages.varying_weight(inv_w);
    return result;
}

ShadedVertex shade_vertex(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                          const Stages& stages) {
    ShadedVertex shaded;
    const ClipVertex clip = stages.vertex_shader(vertex, rotation, rules, stages, &shaded.spaces);
    const ProjectedVertex projected = stages.project(clip, rules, stages, &shaded.spaces);
    shaded.pixel = projected.pixel;
    shaded.rejection = projected.rejection;
    shaded.has_pixel = projected.has_pixel;
    return shaded;
}

} // namespace rasterwalk
