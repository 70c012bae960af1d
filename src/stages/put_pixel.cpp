#include "stages/put_pixel.h"

#include <algorithm>
#include <climits>
#include <cmath>

namespace rasterwalk {

Rectangle drawn_area(Viewport picture) {
    return {0, 0, picture.width, picture.height};
}

Rectangle walk_everywhere(Viewport) {
    return {INT_MIN, INT_MIN, INT_MAX, INT_MAX};
}

Rectangle walk_in_picture(Viewport picture) {
    return drawn_area(picture);
}

float encode_srgb(float channel) {
    constexpr float end_of_line = 0.0031308f;
    if (!(channel > end_of_line)) return 12.92f * channel;
    // In double: in float, 1.055 - 0.055 is a hair less than 1, and white would be byte 254.
    return static_cast<float>(1.055 * double{std::pow(channel, 1.0f / 2.4f)} - 0.055);
}

std::uint8_t to_byte(float channel) {
    // NaN compares false with everything and becomes 0.
    if (!(channel > 0.0f)) return 0;
    return static_cast<std::uint8_t>(std::min(255.0f * channel, 255.0f));
}

float visible_channel(float channel) {
    return std::min(std::max(channel, 0.0f), 1.0f);
}

} // namespace rasterwalk
