#include "pipeline/framebuffer.h"

namespace rasterwalk {

std::size_t Framebuffer::bytes() const {
    return colour.size() * sizeof(glm::vec3) + depth.size() * sizeof(float) +
           owner.size() * sizeof(std::int32_t) + overdraw.size() * sizeof(std::uint32_t) +
           sample_colour.size() * sizeof(SampleColours) +
           sample_depth.size() * sizeof(SampleDepths);
}

void clear(Framebuffer& framebuffer, Viewport size, glm::ivec2 origin, const PictureRules& rules) {
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    framebuffer.size = size;
    framebuffer.origin = origin;
    framebuffer.rules = rules;
    framebuffer.sample_colour.clear();
    framebuffer.sample_depth.clear();
    for_each_plane(framebuffer, [&](auto& plane, auto empty) { plane.assign(count, empty); });
}

float stored_depth(const Framebuffer& framebuffer, int column, int row) {
    const glm::ivec2 cell = framebuffer.rules.depth_cell(column, row);
    return framebuffer.contains(cell.x, cell.y) ? framebuffer.depth[framebuffer.at(cell.x, cell.y)]
                                                : framebuffer.rules.depth_clear;
}

} // namespace rasterwalk
