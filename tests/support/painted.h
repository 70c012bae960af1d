#pragma once

// Pictures by number.

#include <cstdint>
#include <functional>

#include "base/image.h"

namespace rasterwalk::test {

struct Rgb {
    int red, green, blue;
};

/// A picture computed pixel by pixel.
inline Image painted(int width, int height, const std::function<Rgb(int, int)>& colour_at) {
    Image image{width, height, {}};
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Rgb colour = colour_at(column, row);
            for (const int channel : {colour.red, colour.green, colour.blue, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(channel));
        }
    }
    return image;
}

} // namespace rasterwalk::test
