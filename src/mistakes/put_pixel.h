#pragma once

// Mistakes in the slots of stages/put_pixel.h.

#include "stages/put_pixel.h"

namespace rasterwalk {

/// B10, in the slot drawn_area: 0 < x < W and 0 < y < H leaves out the first column and row.
Rectangle drawn_area_without_zero(Viewport picture);

/// B80, in the slot encode: to the power of 1/2.2, which linear numbers do not need; 0 for numbers
/// not above 0.
float encode_gamma(float channel);

inline constexpr float gamma_of_screens = 2.2f;

/// B79, in the slot arrange: blue first.
inline glm::vec3 blue_first(const glm::vec3& colour) {
    return {colour.b, colour.g, colour.r};
}

/// B22, in the slot to_byte: the lowest 8 bits of 255 c; 256 becomes 0 again. 0 for a number
/// whose whole part does not fit in 32 bits.
std::uint8_t to_byte_wrapped(float channel);

/// B22, in the slot visible_channel: the result of to_byte_wrapped, from 0 to 1.
float visible_channel_wrapped(float channel);

} // namespace rasterwalk
