#include "scene/height_map.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace rasterwalk {

namespace {

/// 0..765.
int grey_sum(const Image& image, int column, int row) {
    const auto at = 4 * (static_cast<std::size_t>((row + image.height) % image.height) *
                             static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>((column + image.width) % image.width));
    return image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2];
}

/// The byte for a component of an arrow, -1..1.
std::uint8_t byte_of_part(float part) {
    return static_cast<std::uint8_t>(std::floor((part + 1.0f) / 2.0f * 255.0f + 0.5f));
}

} // namespace

bool looks_like_normals(const Image& image) {
    std::array<std::int64_t, 3> sums{};
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 < 3) sums[i % 4] += image.rgba[i];
    const auto pixels = static_cast<std::int64_t>(image.rgba.size() / 4);
    const auto is_middle = [&](std::int64_t sum) {
        return sum > 96 * pixels && sum < 160 * pixels;
    };
    return is_middle(sums[0]) && is_middle(sums[1]) && sums[2] > 176 * pixels;
}

Image normals_of_heights(const Image& heights, float height) {
    Image normals{heights.width, heights.height, {}};
    normals.rgba.reserve(heights.rgba.size());
    const float scale = height / (2.0f * 3.0f * 255.0f); // over two texels, of three channels
    for (int row = 0; row < heights.height; ++row) {
        for (int column = 0; column < heights.width; ++column) {
            const int right =
                          grey_sum(heights, column + 1, row) - grey_sum(heights, column - 1, row),
                      up = grey_sum(heights, column, row - 1) - grey_sum(heights, column, row + 1);
            const glm::vec3 arrow = glm::normalize(glm::vec3(
                -scale * static_cast<float>(right), -scale * static_cast<float>(up), 1.0f));
            for (int i = 0; i < 3; ++i)
                normals.rgba.push_back(byte_of_part(arrow[i]));
            normals.rgba.push_back(255);
        }
    }
    return normals;
}

} // namespace rasterwalk
