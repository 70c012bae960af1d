#include "stages/put_pixel.h"

#include <algorithm>
#include <climits>

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

std::uint8_t to_byte(float channel) {
    // NaN compares false with everything and becomes 0.
    if (!(channel > 0.0f)) return 0;
    return static_cast<std::uint8_t>(std::min(255.0f * channel, 255.0f));
}

float visible_channel(float channel) {
    return std::min(std::max(channel, 0.0f), 1.0f);
}

} // namespace rasterwalk
