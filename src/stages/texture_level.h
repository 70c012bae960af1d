#pragma once

// The footprint of a pixel in a texture, and the level of the mip chain that suits it.
//
// In:  how u/z, v/z and 1/z change over the screen, and where a fragment lies in the texture.
// Out: how far one pixel reaches in the texture, and the level whose texels are about as large.
// Picture: a pixel as a window frame laid on the texture, stretched where the surface recedes.
//
// Along a row, and along a column, u/z and 1/z change in equal steps, the same over the whole
// polygon. So at every pixel u itself changes like a quotient:
//
//     u = (u/z) / (1/z)      du/dx = (d(u/z)/dx - u d(1/z)/dx) / (1/z)
//
// The footprint has two sides: how far the place moves, in texels, to the next column and to the
// next row. The level is log2 of the longer one: 0 if a pixel spans one texel, 1 if it spans two.
//
// The classic mistake is to take the difference of u between two pixels across the seam of a
// texture, from 0.99 to 0.01: one column of pixels then shows the smallest level.
//
// Source: the derivatives: P. S. Heckbert, "Fundamentals of Texture Mapping and Image Warping",
// Master's thesis, University of California, Berkeley, 1989; the longer side and its logarithm: The
// OpenGL Graphics System, version 4.6 (core profile), section 8.14.1, scale factor and level of
// detail, rho and lambda.

#include <glm/vec2.hpp>

#include "scene/texture.h"
#include "stages/polygon_corners.h"
#include "stages/screen_vertex.h"

namespace rasterwalk {

struct Stages;

/// What is added to the carried place in the texture and to its weight from a pixel to the one on
/// its right, and to the one below: the same over a whole polygon. With perspective-correct
/// interpolation the place is u/z, v/z and the weight 1/z; with affine they are u, v and 1, which
/// does not change.
struct TextureSlope {
    glm::vec2 texcoord_right{0.0f}, texcoord_down{0.0f};
    float weight_right = 0.0f, weight_down = 0.0f;

    friend bool operator==(const TextureSlope&, const TextureSlope&) = default;
};

/// The slope over a polygon, by the largest triangle of its fan: all of them lie in one plane. All
/// 0 if none has an area on the screen.
TextureSlope texture_slope(PolygonCorners vertices, const Stages& stages);

/// How far the place in the texture moves from a pixel to the one on its right, and to the one
/// below: derivatives, as fractions of the texture's width and height.
struct Footprint {
    glm::vec2 right{0.0f}, down{0.0f};

    friend bool operator==(const Footprint&, const Footprint&) = default;
};

/// Where a fragment lies in a texture, and how far it reaches there.
struct TexturePlace {
    glm::vec2 texcoord{0.0f}; ///< u, v: 0..1 in the texture
    Footprint footprint;
};

/// @param carried the carried position, u/z and v/z
/// @param weight  of the carried position, 1/z; not 0
TexturePlace texture_place(const glm::vec2& carried, float weight, const TextureSlope& slope);

/// The length of one side of a footprint in texels of the texture itself.
float side_in_texels(const glm::vec2& side, const TextureLevel& base);

/// The logarithm of a number above 0, base 2, rounded to float only at the end.
float log2_of(float number);

/// The level that suits a footprint: log2 of its longer side in texels. Always from 0 to the last
/// level, even if a texel is larger than a pixel or a side is NaN.
float texture_level(const Footprint& footprint, const Texture& texture);

} // namespace rasterwalk
