#pragma once

// Height maps as normal maps: where the grey of a picture grows, the surface rises.
//
// Source: J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978.

#include "base/image.h"

namespace rasterwalk {

/// Is the picture mostly light blue, as normal maps are, and not grey?
bool looks_like_normals(const Image& image);

/// The normal map of a picture whose grey, the mean of red, green and blue, is a height. Slopes are
/// differences between the texels on both sides; beyond its borders the picture repeats.
/// @param height of white above black, texels; below 0 white is deeper
Image normals_of_heights(const Image& heights, float height);

} // namespace rasterwalk
