#pragma once

#include <string>
#include <vector>

#include "base/image.h"

namespace rasterwalk {

/// How far two pictures may be apart and still count as the same.
struct Tolerance {
    int channel = 0;       ///< largest difference of a channel that is allowed, 0..255
    double mean = 0.0;     ///< largest mean difference over all channels of all pixels
    int pixels_beyond = 0; ///< how many pixels may exceed `channel`
};

/// Pictures of the interface. Measured on the same program with processor features taken away one
/// by one: no channel differs by more than 2, except that without any vector unit two pixels on the
/// border between two enlarged pixels of the picture took the colour of the other.
inline constexpr Tolerance interface_tolerance{.channel = 3, .mean = 0.02, .pixels_beyond = 4};

/// A pixel that differs.
struct DifferingPixel {
    int column = 0;
    int row = 0;
    int difference = 0; ///< of the channel that differs most
};

/// How two pictures differ. Opacity counts as a channel.
struct ImageDifference {
    bool same_size = true;
    int largest = 0;                   ///< of all channels of all pixels
    double mean = 0.0;                 ///< over all channels of all pixels
    int pixels_beyond = 0;             ///< pixels with a channel beyond Tolerance::channel
    std::vector<DifferingPixel> worst; ///< the worst first, from the top among equals; a few
    bool is_within_tolerance = false;
};

/// Pictures of different size are never within a tolerance and have no pixels in common.
ImageDifference compare_images(const Image& actual, const Image& expected,
                               const Tolerance& tolerance);

/// The differences for a person: what is beyond, the worst pixels with both colours, and where on
/// the picture they lie, one character for a part of it. Ends with a line break.
std::string describe_difference(const Image& actual, const Image& expected,
                                const Tolerance& tolerance);

/// Where and how much: unchanged pixels grey and dim, those within the tolerance blue, those beyond
/// it from dark red to yellow. As large as the larger of the two; what only one has is beyond.
Image difference_image(const Image& actual, const Image& expected, const Tolerance& tolerance);

} // namespace rasterwalk
