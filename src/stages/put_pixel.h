#pragma once

// PutPixel: a colour goes on the screen.
//
// In:  a place and a colour, red green blue, each from 0 up; 1 is as bright as the screen can be.
// Out: three bytes, at that place, if it lies in the picture.
// Picture: every channel times 255, the fraction cut off; what is brighter than 1 is as bright
// as 1.
//
// The classic mistakes: `> 0` for `>= 0` in the test whether the place lies in the picture, which
// leaves its first row and column black; and to forget the cut at 1, so that 256 becomes 0 again
// and the brightest places get rings in all colours.

#include <cstdint>

#include "stages/depth_test.h"

namespace rasterwalk {

/// Which places lie in the picture.
enum class Bounds : std::uint8_t {
    inside,        ///< 0 <= x < W and 0 <= y < H
    excludes_zero, ///< 0 < x < W and 0 < y < H: mistake B10
};

/// What a channel above 1 is shown as.
enum class ColourOverOne : std::uint8_t {
    clamp, ///< as 1
    wrap,  ///< as the lowest 8 bits of 255 c: mistake B22
};

/// Pixels from (left, top) up to, not including, (right, bottom).
struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;

    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// By which rules the planes are begun and shown.
struct PictureRules {
    float depth_clear = 0.0f; ///< of the depth buffer where nothing was drawn
    DepthIndex depth_index = DepthIndex::row_major;
    ColourOverOne over_one = ColourOverOne::clamp;

    friend bool operator==(const PictureRules&, const PictureRules&) = default;
};

/// A channel in 8 bits, as the lab's PutPixelSDL does it: 255 c, fraction dropped. NaN becomes 0.
std::uint8_t to_byte(float channel, ColourOverOne rule);

} // namespace rasterwalk
