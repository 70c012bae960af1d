#pragma once

// PutPixel: a colour goes on the screen.
//
// In:  a position and a colour, red green blue, each from 0 up; 1 is as bright as it gets.
// Out: three bytes, at that position, if it lies in the picture.
// Picture: every channel times 255, the fraction cut off; anything brighter than 1 counts as 1.
//          Before that a channel may be encoded by the sRGB curve, which a screen undoes.
//
// The classic mistakes are `> 0` for `>= 0` in the test of whether the position lies in the
// picture, which leaves its first row and column black; forgetting to clamp at 1, so that 256
// becomes 0 again and the brightest places get rings in all colours; and giving blue where the
// screen expects red.
//
// Source: The OpenGL Graphics System, version 4.6 (core profile), section 2.3.5.1: a number from 0
// to 1 as an unsigned normalized integer. The specification rounds to the nearest; the lab
// truncates. The sRGB curve: IEC 61966-2-1:1999.

#include <cstdint>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// The positions that lie in the picture: 0 <= x < W and 0 <= y < H.
Rectangle drawn_area(Viewport picture);

/// Where the rows of a polygon are walked: everywhere. Each fragment is then tested for whether it
/// lies in the picture.
Rectangle walk_everywhere(Viewport picture);

/// Only in the picture, to which the box of the polygon is cut before its rows are walked: four
/// comparisons, and no fragment falls outside.
Rectangle walk_in_picture(Viewport picture);

/// A channel as the lab takes it to the screen: the light itself.
inline float encode_linear(float channel) {
    return channel;
}

/// A channel by the sRGB transfer function: 12.92 c up to 0.0031308, above it
/// 1.055 c^(1/2.4) - 0.055. 0 and 1 stay the same; the curve goes on above 1, and its straight part
/// below 0.
float encode_srgb(float channel);

/// A channel in 8 bits, as the lab's PutPixelSDL does it: 255 c, fraction dropped, at most 255.
/// NaN becomes 0.
std::uint8_t to_byte(float channel);

/// The visible part of a channel, from 0 to 1: it is clamped at both ends.
float visible_channel(float channel);

/// The channels of a colour in the order the lab's screen takes them: red, green, blue.
inline glm::vec3 red_first(const glm::vec3& colour) {
    return colour;
}

/// What happens to a colour on its way to the screen: its channels are put in order, and then each
/// is encoded and made a byte.
struct ScreenRules {
    decltype(&red_first) arrange = red_first;
    decltype(&encode_srgb) encode = encode_linear;
    decltype(&rasterwalk::to_byte) to_byte = rasterwalk::to_byte;
    decltype(&rasterwalk::visible_channel) visible_channel = rasterwalk::visible_channel;

    friend bool operator==(const ScreenRules&, const ScreenRules&) = default;
};

} // namespace rasterwalk
