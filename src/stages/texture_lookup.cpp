#include "stages/texture_lookup.h"

#include <algorithm>
#include <cmath>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// A texel's number modulo the line's length, 0 or more.
int rest_from_zero(int texel, int count) {
    const int rest = texel % count;
    return rest < 0 ? rest + count : rest;
}

/// Two adjacent texels, and how much the second counts.
struct TexelPair {
    int first, second;
    float share;
};

/// The two texels between whose centres a coordinate lies.
TexelPair pair_round(float coordinate, TextureDirection direction, int count,
                     const Stages& stages) {
    const float from_centre =
        call<texel_place>(stages.texel_place, coordinate, direction, count) - 0.5f;
    const float before = std::floor(from_centre);
    const int texel = static_cast<int>(before);
    return {stages.wrap_texel(texel, count), stages.wrap_texel(texel + 1, count),
            from_centre - before};
}

/// Adds the four texels around a position in one level to a colour.
/// @param share of the level
void add_four(const Texture& texture, int level, const glm::vec2& texcoord, float share,
              const Stages& stages, glm::vec3& colour, SampledTexels* taken) {
    const TextureLevel& texels = texture.levels[static_cast<std::size_t>(level)];
    const TexelPair x = pair_round(texcoord.x, TextureDirection::u, texels.width, stages);
    const TexelPair y = pair_round(texcoord.y, TextureDirection::v, texels.height, stages);
    const auto add = [&](int column, int row, float weight) {
        const glm::vec3 texel = call<read_texel>(stages.read_texel, texels, column, row);
        colour += texel * weight;
        if (taken != nullptr) taken->add({level, column, row, weight, texel});
    };
    add(x.first, y.first, (1.0f - x.share) * (1.0f - y.share) * share);
    add(x.second, y.first, x.share * (1.0f - y.share) * share);
    add(x.first, y.second, (1.0f - x.share) * y.share * share);
    add(x.second, y.second, x.share * y.share * share);
}

} // namespace

int wrap_repeat(int texel, int count) {
    return rest_from_zero(texel, count);
}

int wrap_clamp(int texel, int count) {
    return std::clamp(texel, 0, count - 1);
}

int wrap_mirror(int texel, int count) {
    const int rest = rest_from_zero(texel, 2 * count);
    return rest < count ? rest : 2 * count - 1 - rest;
}

float among_texels(float coordinate, int count) {
    constexpr float largest = 0x1p30f;
    const float place = coordinate * static_cast<float>(count);
    return std::abs(place) < largest ? place : 0.0f;
}

glm::vec3 sample_nearest(const Texture& texture, const TexturePlace& place, const Stages& stages,
                         SampledTexels* taken) {
    const TextureLevel& texels = texture.base();
    const auto texel_at = [&stages](float coordinate, TextureDirection direction, int count) {
        const float among = call<texel_place>(stages.texel_place, coordinate, direction, count);
        return stages.wrap_texel(static_cast<int>(std::floor(among)), count);
    };
    const int column = texel_at(place.texcoord.x, TextureDirection::u, texels.width);
    const int row = texel_at(place.texcoord.y, TextureDirection::v, texels.height);
    const glm::vec3 colour = call<read_texel>(stages.read_texel, texels, column, row);
    if (taken != nullptr) taken->add({0, column, row, 1.0f, colour});
    return colour;
}

glm::vec3 sample_bilinear(const Texture& texture, const TexturePlace& place, const Stages& stages,
                          SampledTexels* taken) {
    glm::vec3 colour(0.0f);
    add_four(texture, 0, place.texcoord, 1.0f, stages, colour, taken);
    return colour;
}

glm::vec3 sample_mipmap(const Texture& texture, const TexturePlace& place, const Stages& stages,
                        SampledTexels* taken) {
    glm::vec3 colour(0.0f);
    add_four(texture, nearest_level(stages.texture_level(place.footprint, texture)), place.texcoord,
             1.0f, stages, colour, taken);
    return colour;
}

glm::vec3 sample_trilinear(const Texture& texture, const TexturePlace& place, const Stages& stages,
                           SampledTexels* taken) {
    const float level = stages.texture_level(place.footprint, texture);
    const int first = static_cast<int>(level);
    const float share = level - static_cast<float>(first);
    glm::vec3 colour(0.0f);
    add_four(texture, first, place.texcoord, 1.0f - share, stages, colour, taken);
    if (first < texture.last_level())
        add_four(texture, first + 1, place.texcoord, share, stages, colour, taken);
    return colour;
}

float sample_alpha(const Texture& texture, const TexturePlace& place, const Stages& stages) {
    SampledTexels taken;
    stages.sample_texture(texture, place, stages, &taken);
    float alpha = 0.0f;
    for (const SampledTexel& texel : taken) {
        const TextureLevel& level = texture.levels[static_cast<std::size_t>(texel.level)];
        alpha += texel.weight * level.alpha_at(texel.column, texel.row);
    }
    return alpha;
}

int nearest_level(float level) {
    return std::max(static_cast<int>(std::ceil(level + 0.5f)) - 1, 0);
}

} // namespace rasterwalk
