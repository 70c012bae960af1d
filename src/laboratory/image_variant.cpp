#include "laboratory/image_variant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <glm/vec2.hpp>

#include "picture/resample.h"

namespace rasterwalk {

namespace {

/// The picture with its pixels taken from elsewhere; black where that lies outside. Opacity stays.
template <class From>
Image rearranged(const Image& image, From from) {
    Image result = image;
    const auto width = static_cast<std::size_t>(image.width);
    std::uint8_t* into = result.rgba.data();
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column, into += 4) {
            const glm::ivec2 p = from(column, row);
            if (p.x < 0 || p.x >= image.width || p.y < 0 || p.y >= image.height) {
                std::fill_n(into, 3, std::uint8_t{0});
                continue;
            }
            const std::size_t place =
                4 * (static_cast<std::size_t>(p.y) * width + static_cast<std::size_t>(p.x));
            std::copy_n(image.rgba.data() + place, 3, into);
        }
    }
    return result;
}

} // namespace

ImageDistance image_distance(const Image& a, const Image& b) {
    ImageDistance distance;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
        int pixel = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            pixel += std::abs(static_cast<int>(a.rgba[i + channel]) -
                              static_cast<int>(b.rgba[i + channel]));
        }
        sum += pixel;
        distance.different += pixel > 0 ? 1 : 0;
    }
    const double channels = 0.75 * static_cast<double>(a.rgba.size());
    if (channels > 0.0) distance.mean = static_cast<double>(sum) / channels;
    return distance;
}

Image with_differences_marked(const Image& image, const Image& other, float scale) {
    constexpr std::array<std::uint8_t, 3> orange{0xF0, 0x72, 0x2B};
    Image result = resampled(image, scale);
    for (std::size_t i = 0; i + 3 < result.rgba.size(); i += 4) {
        // Dark enough for the orange to stand out on white too.
        const int sum = 2 * result.rgba[i] + 5 * result.rgba[i + 1] + result.rgba[i + 2];
        const auto grey = static_cast<std::uint8_t>(sum / 16);
        std::fill_n(result.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, grey);
    }
    const auto pixel = [](auto& of, int column, int row) {
        return of.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * of.width + column);
    };
    // The new pixels in which an old one lies, at least in part.
    const auto first = [&](int place, int side) {
        return std::min(static_cast<int>(scale * static_cast<float>(place)), side - 1);
    };
    const auto last = [&](int place, int side) {
        const float end = std::ceil(scale * static_cast<float>(place + 1));
        return std::clamp(static_cast<int>(end) - 1, first(place, side), side - 1);
    };
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const auto from = pixel(image, column, row);
            if (std::equal(from, from + 3, pixel(other, column, row))) continue;
            for (int y = first(row, result.height); y <= last(row, result.height); ++y) {
                for (int x = first(column, result.width); x <= last(column, result.width); ++x)
                    std::copy(orange.begin(), orange.end(), pixel(result, x, y));
            }
        }
    }
    return result;
}

/// FNV-1a.
std::uint64_t fingerprint(const Image& image) {
    std::uint64_t hash = 14695981039346656037u;
    for (const std::uint8_t byte : image.rgba)
        hash = (hash ^ byte) * 1099511628211u;
    return hash;
}

const std::array<OrientationInfo, 4>& orientation_list() {
    static constexpr std::array<OrientationInfo, 4> list{{
        {Orientation::upright, "upright", "upright"},
        {Orientation::mirrored, "mirrored", "Mirrored, left and right exchanged"},
        {Orientation::upside_down, "upside_down", "Upside down"},
        {Orientation::half_turn, "half_turn", "Turned by half a turn"},
    }};
    return list;
}

Image oriented(const Image& image, Orientation orientation) {
    if (orientation == Orientation::upright) return image;
    const bool x = orientation == Orientation::mirrored || orientation == Orientation::half_turn;
    const bool y = orientation == Orientation::upside_down || orientation == Orientation::half_turn;
    return rearranged(image, [&](int column, int row) {
        return glm::ivec2(x ? image.width - 1 - column : column, y ? image.height - 1 - row : row);
    });
}

Image shifted(const Image& image, int columns, int rows) {
    if (columns == 0 && rows == 0) return image;
    return rearranged(
        image, [&](int column, int row) { return glm::ivec2(column - columns, row - rows); });
}

} // namespace rasterwalk
