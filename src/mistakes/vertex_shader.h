#pragma once

// Mistakes in the slots of stages/vertex_shader.h.

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "stages/matrices.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// B24, in the slot rotate_to_camera: R v for v R, the same rotation in the opposite direction.
inline glm::vec3 rotate_transposed(const glm::vec3& minus_camera, const glm::mat3& rotation) {
    return rotation * minus_camera;
}

/// B70, in the slot to_camera_space: (v + C) R, so the camera is on the other side of the world's
/// origin.
CameraPlace to_camera_by_adding(const glm::vec3& position_world, const Camera& camera,
                                const glm::mat3& rotation, const Stages& stages);

/// B71, in the slot to_camera_space: v R - C, turned about the world's origin before it is moved.
/// The report has v R in place of v - C.
CameraPlace to_camera_rotated_first(const glm::vec3& position_world, const Camera& camera,
                                    const glm::mat3& rotation, const Stages& stages);

// The axes of the picture, by what happens to x and y in clip space.

/// As they should be: x right, y down.
inline glm::vec4 axes_kept(const glm::vec4& clip) {
    return clip;
}
/// B25: -f for f turns the picture by half a turn.
inline glm::vec4 axes_mirrored(const glm::vec4& clip) {
    return {-clip.x, -clip.y, clip.z, clip.w};
}
/// B73: f y is taken to the right, and f x down.
inline glm::vec4 axes_exchanged(const glm::vec4& clip) {
    return {clip.y, clip.x, clip.z, clip.w};
}

/// B75, in the slot to_clip_space: w is the distance from the camera instead of z. It has the sign
/// of z, so vertices behind the camera are still recognized.
/// @tparam project the projection that is right
template <auto project>
glm::vec4 to_clip_space_by_distance(const glm::vec3& rotated, const VertexRules& rules) {
    glm::vec4 clip = project(rotated, rules);
    const float distance = std::sqrt(glm::dot(rotated, rotated));
    clip.w = rotated.z > 0.0f ? distance : -distance;
    return clip;
}

/// In the slot to_clip_space: a projection with these axes.
template <auto axes, auto project>
glm::vec4 to_clip_space_with(const glm::vec3& rotated, const VertexRules& rules) {
    return axes(project(rotated, rules));
}

/// B24, B25 and B73 when matrices do the work, in the slot vertex_shader.
template <bool is_transposed, auto axes>
ClipVertex mistaken_matrices(const Vertex& vertex, const glm::mat3& rotation,
                             const VertexRules& rules, const Stages& stages, VertexSpaces* spaces) {
    const glm::mat3 turn = is_transposed ? glm::transpose(rotation) : rotation;
    ClipVertex shaded = vertex_shader_by_matrices(vertex, turn, rules, stages, spaces);
    if (rules.space == SceneSpace::world) shaded.position_clip = axes(shaded.position_clip);
    return shaded;
}

/// B35, in the slot view_matrix: the translation is in the bottom row, as for row vectors, but the
/// point is a column. It comes out turned but not moved, with a spoilt w.
glm::dmat4 view_matrix_with_bottom_row(const glm::dvec3& eye, const glm::dmat3& rotation);

} // namespace rasterwalk
