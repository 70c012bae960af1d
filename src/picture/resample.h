#pragma once

#include "base/image.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The picture in another size: every new pixel is the mean of the old ones that it covers, each
/// weighted by the area covered. Enlarged by a fraction, pixels and lines stay equally wide, with
/// soft borders; made smaller, no line is lost. A last column or row that is only partly covered is
/// partly transparent.
/// @param scale new pixels for each old one, above 0; the sides are rounded up
Image resampled(const Image& image, float scale);

/// Brings a part of a resampled picture up to date, at the cost of that part.
/// @param result  the pixels of `window`, already of that size
/// @param window  pixels of the resampled picture
/// @param changed pixels of the resampled picture, within the window
void resample_part(const Image& image, float scale, const Rectangle& window,
                   const Rectangle& changed, Image& result);

/// The size of a side of the resampled picture.
int resampled_side(int side, float scale);

} // namespace rasterwalk
