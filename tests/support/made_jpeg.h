#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rasterwalk::test {

/// The file of a JPG, baseline.
/// @param quality 1 to 100
/// @param rgb     row by row from the top
std::string jpeg(int width, int height, int quality, const std::vector<std::uint8_t>& rgb);

/// The file of a JPG that comes in several scans, 12 x 10.
std::string progressive_jpeg();

/// A slow change of colour, which a JPG keeps nearly: red, green, blue of each pixel.
std::vector<std::uint8_t> ramp(int width, int height);

} // namespace rasterwalk::test
