#include "mistakes/put_pixel.h"

#include <cmath>

namespace rasterwalk {

Rectangle drawn_area_without_zero(Viewport picture) {
    return {1, 1, picture.width, picture.height};
}

float encode_gamma(float channel) {
    return channel > 0.0f ? std::pow(channel, 1.0f / gamma_of_screens) : 0.0f;
}

std::uint8_t to_byte_wrapped(float channel) {
    constexpr float too_large = 0x1p31f;
    const float value = 255.0f * channel;
    if (!(std::abs(value) < too_large)) return 0;
    return static_cast<std::uint8_t>(static_cast<int>(value) & 0xff);
}

float visible_channel_wrapped(float channel) {
    return static_cast<float>(to_byte_wrapped(channel)) / 255.0f;
}

} // namespace rasterwalk
