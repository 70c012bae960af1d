#include "stages/orthographic.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

float length_between(float near, float far) {
    // Planes that coincide would cause a division by 0.
    constexpr float smallest = 1e-6f;
    const float length = far - near;
    return length == 0.0f ? smallest : length;
}

float clip_z_between(float z, const Projection& projection, float near, float far) {
    switch (projection.clip_depth) {
    case ClipDepth::inv_z:
        break;
    case ClipDepth::ndc:
        return clip_w(far, projection) * ((z - near) / length_between(near, far));
    case ClipDepth::reversed:
        return clip_w(near, projection) * ((far - z) / length_between(near, far));
    }
    return 1.0f;
}

/// z = (a + b depth) / (c + d depth), which is depth_at() solved for z.
struct DepthInverse {
    double a, b, c, d;

    double below(double depth) const { return c + d * depth; }
};

DepthInverse depth_inverse(const DepthRules& rules) {
    const Projection& projection = rules.projection;
    const double mix = projection.mix, near = rules.near, far = rules.far;
    // The float of the length has lost the near plane if the far one is very far away.
    const double length = far != near ? far - near : length_between(rules.near, rules.far);
    const double near_w = clip_w(near, mix), far_w = clip_w(far, mix);
    switch (projection.clip_depth) {
    case ClipDepth::inv_z: // depth = 1 / w
        break;
    case ClipDepth::ndc: // depth = far_w (z - near) / (length w)
        return {far_w * near, length * mix, far_w, -length * (1.0 - mix)};
    case ClipDepth::reversed: // depth = near_w (far - z) / (length w)
        return {near_w * far, -length * mix, near_w, length * (1.0 - mix)};
    }
    return {1.0, -mix, 0.0, 1.0 - mix};
}

} // namespace

PictureScale picture_scale(double focal_length, const Viewport& size,
                           const Projection& projection) {
    const double mix = projection.mix, depth = projection.depth;
    if (!projection.box) return {glm::dvec2(clip_scale(focal_length, mix, depth)), glm::dvec2(0.0)};
    const double left = projection.box->left, right = projection.box->right;
    const double bottom = projection.box->bottom, top = projection.box->top;
    const glm::dvec2 unit = glm::dvec2(size.width, size.height) /
                            glm::dvec2(right - left, top - bottom); // of the world, pixels
    // y of camera space and the rows of the picture run down, y of the window runs up.
    return {clip_w(depth, mix) * unit, 0.5 * unit * glm::dvec2(-left - right, top + bottom)};
}

ViewBox usual_view_box(const VertexRules& rules) {
    const double mix = rules.projection.mix, depth = rules.projection.depth;
    const double focal_length = rules.camera.focal_length, near = rules.near;
    const double reach = clip_w(near, mix) / clip_scale(focal_length, mix, depth);
    const auto right = static_cast<float>(0.5 * rules.viewport.width * reach);
    const auto top = static_cast<float>(0.5 * rules.viewport.height * reach);
    return {-right, right, -top, top};
}

float view_length(const VertexRules& rules) {
    return length_between(rules.near, rules.far);
}

float clip_z(float z, const VertexRules& rules) {
    return clip_z_between(z, rules.projection, rules.near, rules.far);
}

float depth_at(float z, const DepthRules& rules) {
    return clip_z_between(z, rules.projection, rules.near, rules.far) / clip_w(z, rules.projection);
}

double z_of_depth(float depth, const DepthRules& rules) {
    const DepthInverse inverse = depth_inverse(rules);
    return (inverse.a + inverse.b * depth) / inverse.below(depth);
}

double z_between(float from, float to, const DepthRules& rules) {
    const DepthInverse inverse = depth_inverse(rules);
    const double step = double{to} - double{from};
    return step / inverse.below(from) *
           ((inverse.b * inverse.c - inverse.a * inverse.d) / inverse.below(to));
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
