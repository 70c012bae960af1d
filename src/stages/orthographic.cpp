#include "stages/orthographic.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace rasterwalk {

float view_length(const VertexRules& rules) {
    // Planes that lie on each other would leave a division by 0.
    constexpr float smallest = 1e-6f;
    const float length = rules.far - rules.near;
    return length == 0.0f ? smallest : length;
}

float clip_z(float z, const VertexRules& rules) {
    const Projection& projection = rules.projection;
    switch (projection.clip_depth) {
    case ClipDepth::inv_z:
        break;
    case ClipDepth::ndc:
        return clip_w(rules.far, projection) * ((z - rules.near) / view_length(rules));
    case ClipDepth::reversed:
        return clip_w(rules.near, projection) * ((rules.far - z) / view_length(rules));
    }
    return 1.0f;
}

glm::vec4 to_clip_space_mixed(const glm::vec3& rotated, const VertexRules& rules) {
    const float scale = clip_scale(rules);
    return {scale * rotated.x, scale * rotated.y, clip_z(rotated.z, rules),
            clip_w(rotated.z, rules.projection)};
}

float camera_depth(const glm::vec4& clip, const VertexRules& rules) {
    const Projection& projection = rules.projection;
    if (projection.mix == 0.0f) return clip.w;
    const float length = view_length(rules);
    switch (projection.clip_depth) {
    case ClipDepth::inv_z:
        break;
    case ClipDepth::ndc:
        return rules.near + clip.z / clip_w(rules.far, projection) * length;
    case ClipDepth::reversed:
        return rules.far - clip.z / clip_w(rules.near, projection) * length;
    }
    return (clip.w - projection.mix) / (1.0f - projection.mix);
}

float fragment_depth(const Fragment& fragment, float mix) {
    if (mix == 1.0f) return fragment.z;
    const float w = 1.0f / fragment.inv_w;
    return mix == 0.0f ? w : (w - mix) / (1.0f - mix);
}

float origin_depth(const Camera& camera, float near) {
    return std::max(glm::dot(-camera.position, camera_rotation(camera)[2]), near);
}

} // namespace rasterwalk
