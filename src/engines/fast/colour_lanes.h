#pragma once

// Colours of several pixels at once: from light, from a texture (stages/texture_lookup.h), to
// bytes.

#include "engines/fast/fast_data.h"
#include "engines/fast/lanes.h"
#include "engines/fast/light_lanes.h"

namespace {

using namespace rasterwalk::fast;

/// Red, green and blue in lanes.
struct Colour3 {
    Floats red, green, blue;
};

RASTERWALK_INLINE Colour3 at_most_white(const Colour3& colour) {
    const Floats most = all(255.0f);
    return {smaller(colour.red, most), smaller(colour.green, most), smaller(colour.blue, most)};
}
/// As 0x00RRGGBB.
/// @param colour each channel from 0 up to 255
RASTERWALK_INLINE Ints packed(const Colour3& colour) {
    return to_ints(colour.red) << 16 | to_ints(colour.green) << 8 | to_ints(colour.blue);
}

/// Stores a group of colours: the first `count` of them.
RASTERWALK_INLINE void store_colours(const Ints& colours, int count, std::uint32_t* to) {
    if (count >= lane_count)
        store(colours, to);
    else
        store_where(first_lanes(count), colours, to);
}

/// The number of the texel at place `texel` of a line of `count`, as in stages/texture_lookup.h.
RASTERWALK_INLINE std::int32_t wrapped(std::int32_t texel, std::int32_t count, Wrap wrap) {
    if (wrap == Wrap::clamp) return texel < 0 ? 0 : texel >= count ? count - 1 : texel;
    const std::int32_t period = wrap == Wrap::mirror ? 2 * count : count;
    std::int32_t rest = texel % period;
    if (rest < 0) rest += period;
    return rest < count ? rest : period - 1 - rest;
}

/// The colour of a texture at a position in each lane.
RASTERWALK_INLINE Colour3 texture_colour(const Texels& texture, const View& view, const Floats& u,
                                         const Floats& v) {
    // Beyond this there is no position, as in among_texels().
    const auto place = [](const Floats& coordinate, std::int32_t count) {
        const Floats at = coordinate * static_cast<float>(count);
        const Ints is_small = (bits_of(at) & all(0x7fffffff)) < bits_of(all(0x1p30f));
        return choose(is_small, at, Floats{});
    };
    Floats x = place(u, texture.width), y = place(v, texture.height);
    if (view.is_bilinear != 0) {
        x -= 0.5f;
        y -= 0.5f;
    }
    const Ints column = floor_of(x), row = floor_of(y);
    const auto texels = [&](std::int32_t right, std::int32_t down) {
        Ints taken = {};
        for (int lane = 0; lane < lane_count; ++lane) {
            const std::int32_t c = wrapped(column[lane] + right, texture.width, view.wrap);
            const std::int32_t r = wrapped(row[lane] + down, texture.height, view.wrap);
            taken[lane] = static_cast<std::int32_t>(
                texture.texels[static_cast<std::int64_t>(r) * texture.width + c]);
        }
        return taken;
    };
    const auto channels = [](const Ints& texel) {
        const Ints byte = all(255);
        return Colour3{to_floats(texel & byte), to_floats(texel >> 8 & byte),
                       to_floats(texel >> 16 & byte)};
    };
    constexpr float of_byte = 1.0f / 255.0f;
    Colour3 colour{};
    if (view.is_bilinear == 0) {
        colour = channels(texels(0, 0));
    } else {
        const Floats across = x - to_floats(column), along = y - to_floats(row);
        const auto add = [&](std::int32_t right, std::int32_t down, const Floats& weight) {
            const Colour3 texel = channels(texels(right, down));
            colour.red += texel.red * weight;
            colour.green += texel.green * weight;
            colour.blue += texel.blue * weight;
        };
        add(0, 0, (1.0f - across) * (1.0f - along));
        add(1, 0, across * (1.0f - along));
        add(0, 1, (1.0f - across) * along);
        add(1, 1, across * along);
    }
    return {colour.red * of_byte, colour.green * of_byte, colour.blue * of_byte};
}

/// R = reflectance (P D + N).
RASTERWALK_INLINE Colour3 reflected(const LightShares& shares, const Colour3& reflectance,
                                    const View& view) {
    return {reflectance.red * (shares.diffuse * view.power[0] + view.indirect[0]),
            reflectance.green * (shares.diffuse * view.power[1] + view.indirect[1]),
            reflectance.blue * (shares.diffuse * view.power[2] + view.indirect[2])};
}
RASTERWALK_INLINE void add_highlight(const LightShares& shares, const Material& material,
                                     const View& view, Colour3& lit) {
    lit.red += shares.highlight * (material.specular[0] * view.power[0]);
    lit.green += shares.highlight * (material.specular[1] * view.power[1]);
    lit.blue += shares.highlight * (material.specular[2] * view.power[2]);
}

} // namespace
