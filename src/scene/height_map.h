#pragma once

// Height maps as normal maps: where the grey of a picture grows, the surface rises.
//
// Source: J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978.

#include "base/image.h"

namespace rasterwalk {

/// Is the picture light blue on the whole, as normal maps are, and not grey?
bool looks_like_normals(const Image& image);

/// The normal map of a picture whose grey, the mean of red, green and blue, is a height. Slopes are
/// differences between the texels on both sides; beyond a border the picture repeats.
/// @param height texels by which white stands above black; below 0 it lies deeper
Image normals_of_heights(const Image& heights, float height);

} // namespace rasterwalk
