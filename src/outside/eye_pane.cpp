#include "outside/eye_pane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "outside/outside_eye.h"

namespace rasterwalk {

namespace {

/// Below this cosine between its normal and the way to it, a pane is seen edge-on: the pixel under
/// a sample is then not accurate enough to say where it is seen.
constexpr double smallest_cosine = 1e-4;

bool is_seen_along(const EyePane& pane) {
    const glm::dvec3 normal = glm::cross(pane.right, pane.down);
    const double cosine = std::abs(glm::dot(normal, pane.corners[0])) /
                          (glm::length(normal) * glm::length(pane.corners[0]));
    return !(cosine > smallest_cosine);
}

/// The most pixels per side that are examined in a large block.
constexpr int most_samples_a_side = 4;

/// Is this pixel drawn? Outside of the planes it counts as drawn.
bool is_drawn(const Framebuffer& framebuffer, int column, int row) {
    return !framebuffer.contains(column, row) ||
           framebuffer.owner[framebuffer.at(column, row)] >= 0;
}

/// A sum of colours.
struct Sum {
    int red = 0, green = 0, blue = 0, count = 0;

    void add(const std::uint8_t* rgba) {
        red += rgba[0];
        green += rgba[1];
        blue += rgba[2];
        ++count;
    }
    float mean(int Sum::*channel) const {
        return count > 0 ? static_cast<float>(this->*channel) / static_cast<float>(count) : 0.0f;
    }
};

PanePixel block_pixel(const Image& picture, const Framebuffer& framebuffer, int left, int top,
                      int block, float see_through) {
    Sum drawn, other;
    const int right = std::min(left + block, picture.width);
    const int bottom = std::min(top + block, picture.height);
    const int step = std::max(block / most_samples_a_side, 1);
    for (int row = top; row < bottom; row += step) {
        for (int column = left; column < right; column += step) {
            const std::size_t at =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(column);
            (is_drawn(framebuffer, column, row) ? drawn : other).add(&picture.rgba[4 * at]);
        }
    }
    // A line across the block covers it.
    const float lines = static_cast<float>(std::min(block, most_samples_a_side));
    const float covered = std::min(lines * static_cast<float>(drawn.count) /
                                       static_cast<float>(drawn.count + other.count),
                                   1.0f);
    const float opacity = covered + (1.0f - covered) * see_through;
    const auto channel = [&](int Sum::*member) {
        const float light =
            covered * drawn.mean(member) + (1.0f - covered) * see_through * other.mean(member);
        return static_cast<std::uint8_t>(light / std::max(opacity, 1e-3f) + 0.5f);
    };
    return {channel(&Sum::red), channel(&Sum::green), channel(&Sum::blue),
            static_cast<std::uint8_t>(255.0f * opacity + 0.5f)};
}

} // namespace

std::optional<EyePane> eye_pane(const PicturePlane& plane, const OutsideEye& eye) {
    const Viewport size = plane.size;
    if (size.width < 1 || size.height < 1) return std::nullopt;
    EyePane pane{.corners = plane.corners()};
    auto& corners = pane.corners;
    for (glm::dvec3& corner : corners)
        corner = eye.in_eye(corner);
    if (std::none_of(corners.begin(), corners.end(),
                     [&](const glm::dvec3& corner) { return corner.z >= eye.near_distance; }))
        return std::nullopt;
    pane.right = (corners[1] - corners[0]) / static_cast<double>(size.width);
    pane.down = (corners[3] - corners[0]) / static_cast<double>(size.height);
    pane.across = pane.right / glm::dot(pane.right, pane.right);
    pane.along = pane.down / glm::dot(pane.down, pane.down);
    const glm::dvec3 normal = glm::cross(pane.right, pane.down);
    pane.inv_z = normal / glm::dot(normal, pane.corners[0]);
    pane.samples_a_pixel =
        eye.focal_length * glm::length(pane.right) /
        std::max(0.25 * (corners[0].z + corners[1].z + corners[2].z + corners[3].z),
                 eye.near_distance);
    return pane;
}

Rectangle box_of_pixels(const EyePane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area) {
    if (is_empty(pixels)) return {};
    const Rectangle whole = box_around(eye, pane.corners, area);
    if (is_seen_along(pane)) return whole;
    // A point at the border of a pixel may count as its neighbour's.
    const auto place = [&](int column, int row) {
        return pane.corners[0] + static_cast<double>(column) * pane.right +
               static_cast<double>(row) * pane.down;
    };
    const std::array<glm::dvec3, 4> corners{
        place(pixels.left - 1, pixels.top - 1), place(pixels.right + 1, pixels.top - 1),
        place(pixels.right + 1, pixels.bottom + 1), place(pixels.left - 1, pixels.bottom + 1)};
    return box_around(eye, corners, whole);
}

int block_size(const Image& picture, double samples) {
    if (!(samples < 1.0)) return 1;
    const int largest = std::max(std::min(picture.width, picture.height), 1);
    return static_cast<int>(std::min(std::floor(1.0 / std::max(samples, 1e-6)), 1.0 * largest));
}

DownsampledPicture downsampled(const Image& picture, const Framebuffer& framebuffer, int block,
                               float see_through) {
    DownsampledPicture shown;
    shown.block = block;
    shown.width = (picture.width + block - 1) / block;
    shown.blocks.resize(static_cast<std::size_t>(shown.width) *
                        static_cast<std::size_t>((picture.height + block - 1) / block));
    downsample_again(picture, framebuffer, see_through, {0, 0, picture.width, picture.height},
                     shown);
    return shown;
}

void downsample_again(const Image& picture, const Framebuffer& framebuffer, float see_through,
                      const Rectangle& pixels, DownsampledPicture& shown) {
    const int block = shown.block;
    const auto first = [&](int pixel) { return pixel / block * block; };
    for (int top = first(pixels.top); top < pixels.bottom; top += block) {
        for (int left = first(pixels.left); left < pixels.right; left += block) {
            const auto index =
                static_cast<std::size_t>(top / block) * static_cast<std::size_t>(shown.width) +
                static_cast<std::size_t>(left / block);
            shown.blocks[index] = block_pixel(picture, framebuffer, left, top, block, see_through);
        }
    }
}

std::uint32_t over(const PanePixel& pixel, std::uint32_t colour) {
    const std::uint32_t front = pixel.opacity, back = 255U - front;
    const auto mix = [&](std::uint32_t a, std::uint32_t b) {
        return (a * front + b * back + 127U) / 255U;
    };
    return mix(pixel.red, colour & 0xFFU) | (mix(pixel.green, (colour >> 8) & 0xFFU) << 8) |
           (mix(pixel.blue, (colour >> 16) & 0xFFU) << 16);
}

} // namespace rasterwalk
