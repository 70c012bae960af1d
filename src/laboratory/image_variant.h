#pragma once

// Pictures held against each other, and the ways in which a right one may come out turned or moved.

#include <array>
#include <cstdint>

#include "base/image.h"

namespace rasterwalk {

/// How far two pictures of the same size lie apart.
struct ImageDistance {
    double mean = 0.0;          ///< steps of 255, over all channels of all pixels
    std::int64_t different = 0; ///< pixels
};
ImageDistance image_distance(const Image& a, const Image& b);

/// The picture in another size and in grey, and over it in orange what is not so in a picture of
/// the same size: be it one pixel, it is seen.
/// @param scale new pixels for each old one, above 0
Image with_differences_marked(const Image& image, const Image& other, float scale);

/// The same number for the same pixels, and hardly ever for others.
std::uint64_t fingerprint(const Image& image);

enum class Orientation : std::uint8_t { upright, mirrored, upside_down, half_turn };

/// What is said of an orientation.
struct OrientationInfo {
    Orientation orientation;
    const char *id, *name;
};

/// All of them; the first is upright.
const std::array<OrientationInfo, 4>& orientation_list();

/// The picture turned; and moved by some pixels, black where nothing comes from.
Image oriented(const Image& image, Orientation orientation);
Image shifted(const Image& image, int columns, int rows);

} // namespace rasterwalk
