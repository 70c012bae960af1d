#pragma once

// Mistakes with normal maps, in the slots arrow_of_texel and tangent_frame.

#include "stages/normal_map.h"

namespace rasterwalk {

/// B55, in the slot arrow_of_texel: green is taken to run down, so arrows that lean up lean down.
inline glm::vec3 arrow_with_green_turned(const glm::vec3& colour) {
    const glm::vec3 arrow = arrow_of_texel(colour);
    return {arrow.x, -arrow.y, arrow.z};
}

/// B57, in the slot arrow_of_texel: the colour itself is used as the arrow. No channel of a colour
/// is below 0, so every arrow leans to the right and up.
inline glm::vec3 arrow_undecoded(const glm::vec3& colour) {
    return colour;
}

/// B56: no check whether the texture is mirrored.
constexpr float handedness_unasked(const UvDirections&, const TangentFrame&) {
    return 1.0f;
}

/// B56, in the slot tangent_frame.
inline TangentFrame tangent_frame_unasked(const UvDirections& uv, const glm::vec3& normal) {
    return tangent_frame_with<handedness_unasked>(uv, normal);
}

} // namespace rasterwalk
