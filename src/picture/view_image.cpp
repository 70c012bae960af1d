#include "picture/view_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/colour_map.h"

namespace rasterwalk {

namespace {

using Rgb = glm::vec<3, std::uint8_t>;

Rgb depth_colour(float depth, ClipDepth kind, const DepthRange& range) {
    if (!is_depth(depth, kind)) return {0, 0, 0};
    const float place = range.place(depth);
    // For infinite numbers the position may be NaN.
    return viridis(place > 0.0f ? place : 0.0f);
}

/// The farther end first.
DepthRange range_of(ClipDepth kind, const DepthInterval& values) {
    return is_smaller_nearer(kind) ? DepthRange{values.largest, values.smallest}
                                   : DepthRange{values.smallest, values.largest};
}

/// The ranges of the colours, over the whole picture.
struct Scales {
    DepthRange depths;
    std::uint32_t most = 1; ///< fragments on a pixel
};

/// @tparam arranges are the channels in a different order from red first?
/// @param  i        index of the pixel in the planes
template <bool arranges>
Rgb pixel_colour(const Framebuffer& framebuffer, View view, const Scales& scales, std::size_t i) {
    switch (view) {
    case View::colour: {
        const ScreenRules& screen = framebuffer.rules.screen;
        const glm::vec3& colour = framebuffer.colour[i];
        const glm::vec3 c = arranges ? screen.arrange(colour) : colour;
        return {screen_byte(c.r, screen), screen_byte(c.g, screen), screen_byte(c.b, screen)};
    }
    case View::depth: {
        const auto width = static_cast<std::size_t>(framebuffer.size.width);
        const int column = framebuffer.origin.x + static_cast<int>(i % width);
        const int row = framebuffer.origin.y + static_cast<int>(i / width);
        return depth_colour(stored_depth(framebuffer, column, row), framebuffer.rules.depth_kind,
                            scales.depths);
    }
    case View::triangle:
        if (framebuffer.owner[i] >= 0) return distinct_colour(framebuffer.owner[i]);
        break;
    case View::overdraw:
        return overdraw_colour(framebuffer.overdraw[i], scales.most);
    }
    return {0, 0, 0};
}

/// @param pixels of the planes
template <bool arranges>
void paint_with(const Framebuffer& framebuffer, View view, const Scales& scales,
                const Rectangle& pixels, Image& image) {
    const auto width = static_cast<std::size_t>(framebuffer.size.width);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * width;
        for (int column = pixels.left; column < pixels.right; ++column) {
            const std::size_t i = first + static_cast<std::size_t>(column);
            const Rgb rgb = pixel_colour<arranges>(framebuffer, view, scales, i);
            image.rgba[4 * i + 0] = rgb.r;
            image.rgba[4 * i + 1] = rgb.g;
            image.rgba[4 * i + 2] = rgb.b;
            image.rgba[4 * i + 3] = 255;
        }
    }
}

void paint(const Framebuffer& framebuffer, View view, const Scales& scales, const Rectangle& pixels,
           Image& image) {
    if (framebuffer.rules.screen.arrange == red_first)
        paint_with<false>(framebuffer, view, scales, pixels, image);
    else
        paint_with<true>(framebuffer, view, scales, pixels, image);
}

} // namespace

const std::array<ViewInfo, view_count>& view_list() {
    static constexpr std::array<ViewInfo, view_count> list{{
        {View::colour, "colour", "The picture itself.", "Colour",
         "Shows the colours of the picture."},
        {View::depth, "depth 1/z", "The depth of every pixel; bright is near.", "Depth buffer",
         "Shows the depth of every pixel; bright is near."},
        {View::triangle, "triangle", "Which triangle every pixel belongs to.", "Triangle owner",
         "Shows which triangle every pixel belongs to."},
        {View::overdraw, "overdraw", "How many fragments fell on every pixel.", "Overdraw",
         "Shows how many fragments fell on every pixel."},
    }};
    static_assert(is_indexed_by(list, &ViewInfo::view));
    return list;
}

std::uint8_t screen_byte(float channel, const ScreenRules& screen) {
    return screen.to_byte(call<encode_linear>(screen.encode, channel));
}

glm::vec3 shown_colour(const glm::vec3& colour, const ScreenRules& screen) {
    const auto seen = [&](float channel) { return screen.visible_channel(screen.encode(channel)); };
    const glm::vec3 arranged = screen.arrange(colour);
    return {seen(arranged.r), seen(arranged.g), seen(arranged.b)};
}

DepthInterval values_of(const DepthRange& range) {
    return {std::min(range.far, range.near), std::max(range.far, range.near)};
}

std::optional<DepthRange> present_depths(const Framebuffer& framebuffer) {
    float largest = -INFINITY, smallest = INFINITY;
    for (const float depth : framebuffer.depth) {
        if (!has_depth(framebuffer, depth)) continue;
        largest = std::max(largest, depth);
        smallest = std::min(smallest, depth);
    }
    if (!(largest >= smallest)) return std::nullopt;
    return range_of(framebuffer.rules.depth_kind, {smallest, largest});
}

DepthRange shown_depths(ClipDepth kind, const std::optional<DepthInterval>& chosen,
                        const std::optional<DepthRange>& present) {
    if (chosen) return range_of(kind, *chosen);
    return present ? *present : range_of(kind, {0.0f, 1.0f});
}

OverdrawCounts overdraw_counts(const Framebuffer& framebuffer) {
    OverdrawCounts counts;
    for (const std::uint32_t overdraw : framebuffer.overdraw) {
        counts.most = std::max(counts.most, overdraw);
        const std::size_t entry = std::min(overdraw, most_overdraw_listed + 1);
        if (entry >= counts.pixels.size()) counts.pixels.resize(entry + 1);
        ++counts.pixels[entry];
    }
    // The last entry is for all larger numbers.
    if (counts.pixels.size() > most_overdraw_listed + 1)
        counts.pixels.resize(most_overdraw_listed + 1);
    return counts;
}

glm::vec<3, std::uint8_t> overdraw_colour(std::uint32_t fragments, std::uint32_t most) {
    if (fragments == 0) return {0, 0, 0};
    return viridis(static_cast<float>(fragments) / static_cast<float>(std::max(most, 1u)));
}

Image view_image(const Framebuffer& framebuffer, View view,
                 const std::optional<DepthInterval>& depths, std::uint32_t most) {
    Image image;
    make_view_image(framebuffer, view, depths, image, most);
    return image;
}

void make_view_image(const Framebuffer& framebuffer, View view,
                     const std::optional<DepthInterval>& depths, Image& image, std::uint32_t most) {
    image.width = framebuffer.size.width;
    image.height = framebuffer.size.height;
    image.rgba.resize(4 * framebuffer.colour.size());
    Scales scales;
    if (view == View::depth) {
        scales.depths = shown_depths(framebuffer.rules.depth_kind, depths,
                                     depths ? std::nullopt : present_depths(framebuffer));
    }
    if (most > 0) scales.most = most;
    if (view == View::overdraw && most == 0) {
        for (const std::uint32_t overdraw : framebuffer.overdraw)
            scales.most = std::max(scales.most, overdraw);
    }
    paint(framebuffer, view, scales, {0, 0, image.width, image.height}, image);
}

bool is_by_pixel(View view) {
    return view == View::colour || view == View::triangle;
}

void update_view_image(const Framebuffer& framebuffer, View view, const Rectangle& pixels,
                       Image& image) {
    paint(framebuffer, view, {}, pixels, image);
}

} // namespace rasterwalk
