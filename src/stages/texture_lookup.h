#pragma once

// Texture lookup: which texels colour a fragment, and how much each of them counts.
//
// In:  a position in a texture, u from the left and v from the top, and the footprint of the pixel.
// Out: a colour: one texel, or the mean of four, or of eight, by their weights.
// Picture: a texture of n texels is n squares side by side, and a texel is the colour in the middle
//          of its square: its centre lies at (i + 1/2) / n.
//
// Nearest takes the texel in whose square the position lies. Bilinear takes the four whose centres
// surround it, each by how near it is along both axes; that is right as long as a pixel is not
// larger than a texel. If it is larger, most texels would be passed over and the picture would
// glitter; so the mip chain holds smaller pictures, and the level is used whose texels are about as
// large as the pixel. Mipmap takes the nearest level, which shows a seam where the next one begins;
// trilinear mixes the two levels between which the footprint lies.
//
// Beyond the texture, the wrap says which texel is used: the texture repeats, its border goes on,
// or its mirror image follows.
//
// The classic mistakes are centres at i / n, so that bilinear moves the texture by half a texel; v
// from the bottom although the rows begin at the top; and wrapping u instead of the texel's number,
// so that the last texel does not mix with the first.
//
// Source: The OpenGL Graphics System, version 4.6 (core profile), sections 8.14.2, coordinate
// wrapping and texel selection, and 8.14.3, mipmapping; L. Williams, "Pyramidal Parametrics",
// Computer Graphics 17(3), SIGGRAPH 1983, on trilinear.

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "stages/texture_level.h"

namespace rasterwalk {

/// Do surfaces show the textures that the scene gives them?
enum class TextureUse : std::uint8_t { on, off };

/// Which texels colour a fragment.
enum class TextureFilter : std::uint8_t {
    nearest,   ///< the one in which it lies
    bilinear,  ///< the four around it
    mipmap,    ///< the four around it, in the level nearest to its footprint
    trilinear, ///< the four around it in each of the two levels next to its footprint
};

/// What comes beyond the borders of a texture.
enum class TextureWrap : std::uint8_t {
    repeat, ///< the texture again
    clamp,  ///< the texels of its border
    mirror, ///< the texture again, every second time flipped
};

/// What the alpha of a texture does to a fragment.
enum class TextureAlpha : std::uint8_t {
    cut_out, ///< below `cut_out_limit` the fragment is discarded, else it is as opaque as its
             ///< surface
    blend,   ///< it multiplies the alpha that the fragment is blended with
    off,     ///< nothing: every texel is opaque
};

/// With less alpha than this a fragment is cut out: the alpha test of OpenGL 1.0, with GL_GEQUAL
/// and this reference value.
inline constexpr float cut_out_limit = 0.5f;

/// A texel that a fragment took.
struct SampledTexel {
    int level = 0;
    int column = 0, row = 0; ///< in the level; below 0 with mistake B67
    float weight = 0.0f;     ///< 0..1; those of all texels that a fragment takes add up to 1
    glm::vec3 colour{0.0f};

    friend bool operator==(const SampledTexel&, const SampledTexel&) = default;
};

/// The texels that a fragment took, in the order in which their colours were added.
struct SampledTexels {
    std::array<SampledTexel, 8> list;
    int count = 0;

    void add(const SampledTexel& texel) { list[static_cast<std::size_t>(count++)] = texel; }
    const SampledTexel* begin() const { return list.data(); }
    const SampledTexel* end() const { return list.data() + count; }
};

/// The number of the texel at place `texel` of a line of `count` texels, count > 0. It is 0 or more
/// for every place, even below 0 and beyond the last.
int wrap_repeat(int texel, int count);
int wrap_clamp(int texel, int count);
int wrap_mirror(int texel, int count);

/// Where a texture coordinate lies among `count` texels: texel i goes from i to i + 1. NaN, or a
/// coordinate too large to be counted, lies at 0.
float among_texels(float coordinate, int count);

/// The two directions in a texture.
enum class TextureDirection : std::uint8_t { u, v };

/// Where a texture coordinate lies among the `count` texels of its direction: v runs down, as rows
/// do, and the centre of texel i lies at i + 1/2.
inline float texel_place(float coordinate, TextureDirection, int count) {
    return among_texels(coordinate, count);
}

/// The colour of a texel, as stored in a level.
/// @param column 0 <= column < level.width
/// @param row    0 <= row < level.height
inline glm::vec3 read_texel(const TextureLevel& level, int column, int row) {
    return level.at(column, row);
}

/// The colour of a texture at a position.
/// @param stages the table whose functions find the position, wrap and read
/// @param taken  receives the texels, or null
glm::vec3 sample_nearest(const Texture& texture, const TexturePlace& place, const Stages& stages,
                         SampledTexels* taken);
glm::vec3 sample_bilinear(const Texture& texture, const TexturePlace& place, const Stages& stages,
                          SampledTexels* taken);
glm::vec3 sample_mipmap(const Texture& texture, const TexturePlace& place, const Stages& stages,
                        SampledTexels* taken);
glm::vec3 sample_trilinear(const Texture& texture, const TexturePlace& place, const Stages& stages,
                           SampledTexels* taken);

/// The alpha of a texture at a position, 0 to 1: from the texels whose colours are mixed there,
/// with the same weights.
float sample_alpha(const Texture& texture, const TexturePlace& place, const Stages& stages);

/// The whole level nearest to a level; halfway between two, the larger picture, as in OpenGL.
int nearest_level(float level);

} // namespace rasterwalk
