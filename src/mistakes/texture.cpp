#include "mistakes/texture.h"

#include <cmath>

namespace rasterwalk {

float texel_place_upside_down(float coordinate, int count, TexelLine line) {
    return texel_place(line == TexelLine::row ? 1.0f - coordinate : coordinate, count, line);
}

float texel_place_half_off(float coordinate, int count, TexelLine) {
    return counted_place(coordinate * static_cast<float>(count) + 0.5f);
}

float texel_place_wrapped(float coordinate, int count, TexelLine line) {
    return texel_place(coordinate - std::floor(coordinate), count, line);
}

} // namespace rasterwalk
