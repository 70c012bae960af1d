#include "pipeline/framebuffer.h"

namespace rasterwalk {

std::size_t Framebuffer::bytes() const {
    return colour.size() * sizeof(glm::vec3) + depth.size() * sizeof(float) +
           owner.size() * sizeof(std::int32_t) + overdraw.size() * sizeof(std::uint32_t);
}

void clear(Framebuffer& framebuffer, Viewport size, glm::ivec2 origin, const PictureRules& rules) {
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    framebuffer.size = size;
    framebuffer.origin = origin;
    framebuffer.colour.assign(count, glm::vec3(0.0f));
    framebuffer.rules = rules;
    framebuffer.depth.assign(count, rules.depth_clear);
    framebuffer.owner.assign(count, -1);
    framebuffer.overdraw.assign(count, 0);
}

float stored_depth(const Framebuffer& framebuffer, int column, int row) {
    const glm::ivec2 cell = framebuffer.rules.depth_cell(column, row);
    return framebuffer.contains(cell.x, cell.y) ? framebuffer.depth[framebuffer.at(cell.x, cell.y)]
                                                : framebuffer.rules.depth_clear;
}

} // namespace rasterwalk
