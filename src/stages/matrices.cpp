#include "stages/matrices.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "stages/orthographic.h"
#include "stages/project.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// How far ndc is stretched over the picture: half its sides, in pixels.
glm::dvec2 half_of(const Viewport& viewport) {
    return {viewport.width / 2.0, viewport.height / 2.0};
}

/// The third coordinate as ClipDepth wants it, from clip space that has the one of ndc z.
double depth_for(ClipDepth wanted, const glm::dvec4& clip) {
    switch (wanted) {
    case ClipDepth::inv_z:
        break;
    case ClipDepth::ndc:
        return clip.z;
    case ClipDepth::reversed:
        return clip.w - clip.z;
    }
    return 1.0;
}

} // namespace

glm::dmat4 view_matrix(const glm::dvec3& eye, const glm::dmat3& rotation) {
    // The rows of R, applied to the point after it is moved by -eye.
    const glm::dmat3 turn = glm::transpose(rotation);
    glm::dmat4 matrix(turn);
    matrix[3] = glm::dvec4(turn * -eye, 1.0);
    return matrix;
}

glm::dmat4 projection_matrix(const VertexRules& rules) {
    const double mix = rules.projection.mix, near = rules.near;
    const double length = view_length(rules), far = near + length;
    const glm::dvec2 half = half_of(rules.viewport);
    const PictureScale picture =
        picture_scale(rules.camera.focal_length, rules.viewport, rules.projection);
    const glm::dvec2 scale = picture.scale / half, shift = picture.shift / half;
    const double w_far = clip_w(far, mix);
    // Written in rows, as you read it, and then transposed into glm's columns.
    return glm::transpose(glm::dmat4{{scale.x, 0.0, shift.x * (1.0 - mix), shift.x * mix},
                                     {0.0, scale.y, shift.y * (1.0 - mix), shift.y * mix},
                                     {0.0, 0.0, w_far / length, -w_far * near / length},
                                     {0.0, 0.0, 1.0 - mix, mix}});
}

double ndc_depth(double z, const VertexRules& rules) {
    const glm::dvec4 clip = projection_matrix(rules) * glm::dvec4(0.0, 0.0, z, 1.0);
    return clip.z / clip.w;
}

glm::dmat4 viewport_matrix(const VertexRules& rules) {
    const glm::dvec2 half = half_of(rules.viewport);
    const glm::dvec2 middle(viewport_middle(rules));
    return glm::transpose(glm::dmat4{{half.x, 0.0, 0.0, middle.x},
                                     {0.0, half.y, 0.0, middle.y},
                                     {0.0, 0.0, 1.0, 0.0},
                                     {0.0, 0.0, 0.0, 1.0}});
}

ClipVertex vertex_shader_by_matrices(const Vertex& vertex, const glm::mat3& rotation,
                                     const VertexRules& rules, const Stages& stages,
                                     VertexSpaces* spaces) {
    if (rules.space == SceneSpace::pixels)
        return vertex_shader(vertex, rotation, rules, stages, spaces);
    // A real program multiplies the matrices together once per frame, and each vertex by the
    // product; here they stay separate, like the spaces. Tm is done: the scene is read with every
    // object in the world.
    const glm::dvec3 eye(rules.camera.position), world(vertex.position);
    const glm::dvec4 camera =
        stages.view_matrix(eye, glm::dmat3(rotation)) * glm::dvec4(world, 1.0);
    const glm::dvec4 clip = projection_matrix(rules) * camera;
    const glm::dvec2 scale = half_of(rules.viewport);
    if (spaces != nullptr) {
        spaces->add("world", vertex.position);
        spaces->add("minus_camera", glm::vec3(world - eye));
        spaces->add("rotated", glm::vec3(camera));
    }
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    if (!std::isfinite(camera.x + camera.y + camera.z))
        return {glm::vec4(not_a_number), start_varyings(vertex, rules, stages)};
    const glm::vec4 position(glm::dvec4(scale.x * clip.x, scale.y * clip.y,
                                        depth_for(rules.projection.clip_depth, clip), clip.w));
    return {position, start_varyings(vertex, rules, stages)};
}

} // namespace rasterwalk
