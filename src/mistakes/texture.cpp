#include "mistakes/texture.h"

namespace rasterwalk {

float texel_place_upside_down(float coordinate, TextureDirection direction, int count) {
    return among_texels(direction == TextureDirection::v ? 1.0f - coordinate : coordinate, count);
}

float texel_place_of_whole_centres(float coordinate, TextureDirection, int count) {
    return among_texels(coordinate, count) + 0.5f;
}

float texture_level_along_x(const Footprint& footprint, const Texture& texture) {
    return texture_level({footprint.right, glm::vec2(0.0f)}, texture);
}

int wrap_by_remainder(int texel, int count) {
    return texel % count;
}

glm::vec3 read_texel_in_memory(const TextureLevel& level, int column, int row) {
    const std::int64_t at = std::int64_t{row} * level.width + column;
    const bool is_inside = at >= 0 && at < std::int64_t{level.width} * level.height;
    return is_inside ? level.texels[static_cast<std::size_t>(at)] : glm::vec3(0.0f);
}

} // namespace rasterwalk
