#pragma once

// Mistakes in the slots of stages/vertex_shader.h.

#include <glm/matrix.hpp>

#include "stages/matrices.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

/// B24, in the slot rotate_to_camera: R v for v R, the same turn the other way round.
inline glm::vec3 rotate_transposed(const glm::vec3& minus_camera, const glm::mat3& rotation) {
    return rotation * minus_camera;
}

/// B25, in the slot to_clip_space: -f for f turns the picture by half a turn.
/// @tparam project the projection that is right
template <auto project>
glm::vec4 to_clip_space_mirrored(const glm::vec3& rotated, const VertexRules& rules) {
    const glm::vec4 clip = project(rotated, rules);
    return {-clip.x, -clip.y, clip.z, clip.w};
}

/// B24 and B25 where matrices do the work, in the slot vertex_shader.
template <bool is_transposed, bool is_mirrored>
ClipVertex mistaken_matrices(const Vertex& vertex, const glm::mat3& rotation,
                             const VertexRules& rules, const Stages& stages, VertexSpaces* spaces) {
    const glm::mat3 turn = is_transposed ? glm::transpose(rotation) : rotation;
    ClipVertex shaded = vertex_shader_by_matrices(vertex, turn, rules, stages, spaces);
    if (is_mirrored && rules.space == SceneSpace::world) {
        shaded.position_clip.x = -shaded.position_clip.x;
        shaded.position_clip.y = -shaded.position_clip.y;
    }
    return shaded;
}

/// B35, in the slot view_matrix: the translation stands in the bottom row, as row vectors have it,
/// and the point is a column all the same. It comes out turned but not moved, with a spoilt w.
glm::dmat4 view_matrix_with_bottom_row(const glm::dvec3& eye, const glm::dmat3& rotation);

} // namespace rasterwalk
