#pragma once

// Do two engines draw the same? Only then can their times be compared.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// A picture with 8 bits per channel.
struct EnginePicture {
    Viewport size;
    /// 0xXXRRGGBB, row by row from the top; the highest byte means nothing.
    std::vector<std::uint32_t> colour;
};

/// How two pictures of the same size differ. A pixel differs if a channel does by more than 1/255:
/// floats rounded to bytes can fall on either side.
struct PictureDifference {
    std::int64_t pixels = 0;    ///< of the whole picture
    std::int64_t different = 0; ///< of them
    int largest = 0;            ///< difference of a channel, 255ths
    glm::ivec2 first{-1, -1};   ///< column and row of the first pixel that differs; -1: none

    friend bool operator==(const PictureDifference&, const PictureDifference&) = default;
};

/// Throws std::invalid_argument if the pictures differ in size.
PictureDifference difference_of(const EnginePicture& a, const EnginePicture& b);

/// One in this many pixels may differ, 0.02 %: where an edge meets the centre of a pixel, the
/// floats of two engines can decide differently.
inline constexpr std::int64_t pixels_to_one_that_differs = 5000;
bool do_agree(const PictureDifference& difference);

/// "1234 of 250000 pixels differ (0.494 %), by up to 87/255, the first at 10,5".
std::string difference_text(const PictureDifference& difference);

} // namespace rasterwalk
