#include "pipeline/clearing.h"

#include <algorithm>
#include <cstddef>

#include "pipeline/draw.h"

namespace rasterwalk {

PictureRules picture_rules(const Frame& frame) {
    Framebuffer empty;
    clear(empty, frame, {0, 0}, {0, 0});
    return empty.rules;
}

void clear_part(Framebuffer& framebuffer, const Rectangle& pixels) {
    if (is_empty(pixels)) return;
    const auto width = static_cast<std::ptrdiff_t>(framebuffer.size.width);
    for_each_plane(framebuffer, [&](auto& plane, auto empty) {
        for (int row = pixels.top; row < pixels.bottom; ++row)
            std::fill_n(plane.begin() + row * width + pixels.left, pixels.right - pixels.left,
                        empty);
    });
}

void begin_clearing(Framebuffer& framebuffer, const Frame& frame) {
    framebuffer.size = frame.settings.viewport;
    framebuffer.origin = {0, 0};
    framebuffer.rules = picture_rules(frame);
    const std::size_t count = static_cast<std::size_t>(framebuffer.size.width) *
                              static_cast<std::size_t>(framebuffer.size.height);
    framebuffer.sample_colour.clear();
    framebuffer.sample_depth.clear();
    for_each_plane(framebuffer, [&](auto& plane, auto) {
        plane.clear();
        plane.reserve(count);
    });
}

bool clear_rows(Framebuffer& framebuffer, const WorkLimit& limit) {
    const Viewport size = framebuffer.size;
    const auto width = static_cast<std::size_t>(size.width);
    const int done =
        size.width > 0 ? static_cast<int>(framebuffer.colour.size() / width) : size.height;
    const int end = done + rows_within(limit, clear_pixel_work, size, done);
    for_each_plane(framebuffer, [&](auto& plane, auto empty) {
        plane.resize(static_cast<std::size_t>(end) * width, empty);
    });
    return end == size.height;
}

} // namespace rasterwalk
