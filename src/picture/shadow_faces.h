#pragma once

// The six faces of the shadow map as small pictures: what the lamp saw, all around.

#include <array>

#include "base/image.h"
#include "stages/shadow.h"

namespace rasterwalk {

/// The faces in the order of their passes. All have the same colours for the same depth: the
/// nearest thing that the lamp saw is the brightest, the farthest the darkest, in equal steps of z;
/// black where it saw nothing.
struct ShadowFacePictures {
    std::array<Image, shadow_face_count> faces;
    float nearest = 0.0f, farthest = 0.0f; ///< z of what is shown, world units; 0: nothing is
};

/// The largest side of such a picture, pixels.
inline constexpr int largest_face_side = 256;

/// A map with fewer texels is shown texel by texel; of a larger one each pixel shows the texel in
/// the middle of those that it covers. Costs at most six times largest_face_side squared.
/// @param side of each picture, at most: pixels, from 1; a map without texels has no pictures
ShadowFacePictures shadow_face_pictures(const ShadowMap& map, int side);

} // namespace rasterwalk
