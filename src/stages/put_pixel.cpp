#include "stages/put_pixel.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

namespace {

/// The lowest 8 bits of the whole number; 0 for what no whole number of 32 bits can hold.
std::uint8_t lowest_bits(float value) {
    constexpr float too_large = 0x1p31f;
    if (!(std::abs(value) < too_large)) return 0;
    return static_cast<std::uint8_t>(static_cast<int>(value) & 0xff);
}

} // namespace

std::uint8_t to_byte(float channel, ColourOverOne rule) {
    if (rule == ColourOverOne::wrap) return lowest_bits(255.0f * channel);
    // NaN compares false with everything and becomes 0.
    if (!(channel > 0.0f)) return 0;
    return static_cast<std::uint8_t>(std::min(255.0f * channel, 255.0f));
}

} // namespace rasterwalk
