#pragma once

#include "base/image.h"

namespace rasterwalk {

/// The picture in another size: every new pixel is the mean of what it covers of the old ones, each
/// weighted by the area covered. Enlarged by a fraction, pixels and lines so stay equally wide,
/// with soft borders; made smaller, no line is lost. A last column or row that is only partly
/// covered is partly transparent.
/// @param scale new pixels for each old one, above 0; the sides are rounded up
Image resampled(const Image& image, float scale);

/// The size of a side of the resampled picture.
int resampled_side(int side, float scale);

} // namespace rasterwalk
