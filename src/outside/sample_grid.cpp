#include "outside/sample_grid.h"

#include <algorithm>

#include <glm/common.hpp>

namespace rasterwalk {

void resize(SampleGrid& grid, glm::ivec2 size) {
    grid.size = glm::max(size, glm::ivec2(0));
    const std::size_t count =
        static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y);
    grid.inv_z.resize(count);
    grid.colour.resize(count);
    grid.id.resize(count);
}

std::uint32_t packed_colour(const glm::vec3& colour) {
    std::uint32_t packed = 0;
    for (int i = 0; i < 3; ++i) {
        const float channel = colour[i] > 0.0f ? std::min(colour[i], 1.0f) : 0.0f;
        packed |= static_cast<std::uint32_t>(255.0f * channel + 0.5f) << (8 * i);
    }
    return packed;
}

} // namespace rasterwalk
