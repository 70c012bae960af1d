#include "outside/eye_texture.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "stages/texture_lookup.h"

namespace rasterwalk {

EyeTexture::EyeTexture(const Frame& frame, int triangle, std::span<const glm::dvec3> corners,
                       const OutsideEye& eye)
    : stages_(&frame.stages), corner_(corners[0]) {
    const Texture* const texture =
        is_textured(frame) ? texture_of(*frame.scene, triangle) : nullptr;
    if (texture == nullptr) return;
    const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) return;
    // The weights of the other two corners: 1 there, and 0 along the opposite edge.
    const glm::dvec3 weight_b = glm::cross(ac, normal) / square;
    const glm::dvec3 weight_c = glm::cross(normal, ab) / square;
    const auto texcoord = [&](int corner) {
        return glm::dvec2(frame.scene->corner(triangle, corner).texcoord);
    };
    texcoord_ = texcoord(0);
    const glm::dvec2 to_b = texcoord(1) - texcoord_, to_c = texcoord(2) - texcoord_;
    u_slope_ = weight_b * to_b.x + weight_c * to_c.x;
    v_slope_ = weight_b * to_b.y + weight_c * to_c.y;
    texels_ = std::max(glm::length(u_slope_) * texture->base().width,
                       glm::length(v_slope_) * texture->base().height) /
              eye.focal_length;
    texture_ = texture;
}

glm::vec3 EyeTexture::at(const glm::dvec3& place) const {
    if (texture_ == nullptr) return glm::vec3(1.0f);
    // As many levels as the covered texels can be halved.
    int exponent = 0;
    const double covered = texels_ * place.z;
    if (covered > 1.0 && std::isfinite(covered)) std::frexp(covered, &exponent);
    const int number = std::clamp(exponent - 1, 0, texture_->last_level());
    const TextureLevel& level = texture_->levels[static_cast<std::size_t>(number)];
    const auto texel = [&](double coordinate, TextureDirection direction, int count) {
        const float among = stages_->texel_place(static_cast<float>(coordinate), direction, count);
        return stages_->wrap_texel(static_cast<int>(std::floor(among)), count);
    };
    const glm::dvec3 offset = place - corner_;
    const int column =
        texel(texcoord_.x + glm::dot(u_slope_, offset), TextureDirection::u, level.width);
    const int row =
        texel(texcoord_.y + glm::dot(v_slope_, offset), TextureDirection::v, level.height);
    return stages_->read_texel(level, column, row);
}

} // namespace rasterwalk
