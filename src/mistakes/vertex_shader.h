#pragma once

// Mistakes in the slots of stages/vertex_shader.h.

#include "stages/vertex_shader.h"

namespace rasterwalk {

/// B24, in the slot rotate_to_camera: R v for v R, the same turn the other way round.
inline glm::vec3 rotate_transposed(const glm::vec3& minus_camera, const glm::mat3& rotation) {
    return rotation * minus_camera;
}

/// B25, in the slot to_clip_space: -f for f turns the picture by half a turn.
inline glm::vec4 to_clip_space_mirrored(const glm::vec3& rotated, float focal_length) {
    return to_clip_space(rotated, -focal_length);
}

} // namespace rasterwalk
