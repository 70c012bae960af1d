#include "stages/shadow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// The bias, plus what slanted light adds: over a texel, the depth of the surface changes by the
/// texel's size times the tangent of the slant.
float bias_at(const ShadowPoint& point, float depth, int resolution, const ShadowRules& rules) {
    if (rules.slope_bias == 0.0f) return rules.bias;
    const float texel = 2.0f * depth / static_cast<float>(resolution);
    return rules.bias + rules.slope_bias * texel * shadow_slope(point.cosine);
}

} // namespace

float shadow_slope(float cosine) {
    const float usual = std::clamp(cosine, 0.01f, 1.0f);
    return std::sqrt(1.0f - usual * usual) / usual;
}

ShadowTerms no_shadow(const ShadowPoint&, const Occluders&, const Stages&) {
    return {};
}

ShadowTerms shadow_by_ray(const ShadowPoint& point, const Occluders& occluders,
                          const Stages& stages) {
    ShadowTerms terms;
    terms.is_tested = true;
    terms.point = point;
    terms.ray = stages.shadow_ray(point, occluders.rules.offset);
    terms.hit = occluders.triangles->first_hit(terms.ray);
    terms.lit = terms.hit.is_hit() ? 0.0f : 1.0f;
    return terms;
}

int shadow_face_of(const glm::vec3& from_lamp) {
    const float x = std::abs(from_lamp.x), y = std::abs(from_lamp.y), z = std::abs(from_lamp.z);
    if (x >= y && x >= z) return from_lamp.x >= 0.0f ? 0 : 1;
    if (y >= z) return from_lamp.y >= 0.0f ? 2 : 3;
    return from_lamp.z >= 0.0f ? 4 : 5;
}

glm::vec2 shadow_place(const glm::vec3& from_face, int resolution) {
    const float focal_length = 0.5f * static_cast<float>(resolution);
    const int half = resolution / 2; // like viewport_middle()
    const auto middle = static_cast<float>(half);
    const float inv_z = 1.0f / from_face.z;
    return {focal_length * from_face.x * inv_z + middle,
            focal_length * from_face.y * inv_z + middle};
}

namespace {

/// The texel of a coordinate, moved to the border if it lies beyond.
int texel_at(float place, int resolution) {
    // Clamped before the conversion: a number too large for an int cannot be converted.
    const float whole = std::floor(place);
    return whole > 0.0f ? static_cast<int>(std::min(whole, static_cast<float>(resolution - 1))) : 0;
}

} // namespace

int nearest_shadow_texel(const glm::vec2& place, int resolution, ShadowTexels& texels) {
    texels[0] = {texel_at(place.x, resolution), texel_at(place.y, resolution)};
    return 1;
}

int four_shadow_texels(const glm::vec2& place, int resolution, ShadowTexels& texels) {
    // The centre of texel i lies at i + 1/2.
    const int left = texel_at(place.x - 0.5f, resolution);
    const int right = texel_at(place.x + 0.5f, resolution);
    const int top = texel_at(place.y - 0.5f, resolution);
    const int bottom = texel_at(place.y + 0.5f, resolution);
    texels = {glm::ivec2(left, top), glm::ivec2(right, top), glm::ivec2(left, bottom),
              glm::ivec2(right, bottom)};
    return 4;
}

ShadowTerms shadow_by_map(const ShadowPoint& point, const Occluders& occluders,
                          const Stages& stages) {
    const ShadowMap& map = *occluders.map;
    ShadowTerms terms;
    const glm::vec3 from_lamp = point.position_world - map.lamp;
    const int which = shadow_face_of(from_lamp);
    const ShadowFace& face = map.faces[static_cast<std::size_t>(which)];
    // 0 is added so that no component is −0.
    const glm::vec3 from_face = from_lamp * face.axes + 0.0f;
    // At the lamp itself there is no direction.
    if (!(from_face.z > 0.0f)) return terms;
    terms.is_tested = true;
    terms.point = point;
    terms.face = which;
    terms.from_face = from_face;
    terms.place = shadow_place(from_face, map.resolution);
    terms.bias = bias_at(point, from_face.z, map.resolution, occluders.rules);
    terms.compared = from_face.z - terms.bias;
    ShadowTexels texels{};
    terms.texel_count = stages.shadow_texels(terms.place, map.resolution, texels);
    int lit = 0;
    for (int i = 0; i < terms.texel_count; ++i) {
        const glm::ivec2& at = texels[static_cast<std::size_t>(i)];
        const float inv_depth = face.inv_depth[static_cast<std::size_t>(at.y) *
                                                   static_cast<std::size_t>(map.resolution) +
                                               static_cast<std::size_t>(at.x)];
        // compared <= 1 / inv_depth, for an inv_depth of 0 too.
        const bool is_lit = terms.compared * inv_depth <= 1.0f;
        terms.texels[static_cast<std::size_t>(i)] = {at.x, at.y, inv_depth, is_lit};
        lit += is_lit ? 1 : 0;
    }
    terms.lit = static_cast<float>(lit) / static_cast<float>(terms.texel_count);
    return terms;
}

} // namespace rasterwalk
