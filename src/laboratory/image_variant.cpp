#include "laboratory/image_variant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <fmt/format.h>

#include <glm/vec2.hpp>

#include "picture/resample.h"

namespace rasterwalk {

namespace {

/// The picture with its pixels taken from elsewhere; black where that is outside. Opacity stays.
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

/// Steps of 255: the largest that is no difference, and the smallest that counts in full.
constexpr int same_within = 1, wholly_wrong = 16;

/// A hash with one more pixel: FNV-1a, by whole pixels.
std::uint64_t hashed(std::uint64_t hash, const std::uint8_t* pixel) {
    const std::uint32_t bytes = std::uint32_t{pixel[0]} | std::uint32_t{pixel[1]} << 8u |
                                std::uint32_t{pixel[2]} << 16u | std::uint32_t{pixel[3]} << 24u;
    hash = (hash ^ bytes) * 1099511628211u;
    return hash ^ hash >> 32u;
}

} // namespace

bool is_same_pixel(const std::uint8_t* a, const std::uint8_t* b) {
    for (int channel = 0; channel < 3; ++channel) {
        if (std::abs(static_cast<int>(a[channel]) - static_cast<int>(b[channel])) > same_within)
            return false;
    }
    return true;
}

bool is_black(const std::uint8_t* pixel) {
    return std::max({pixel[0], pixel[1], pixel[2]}) <= same_within;
}

bool has_same_hue(const std::uint8_t* a, const std::uint8_t* b) {
    constexpr int least_sum = 30, hundredths_apart = 3;
    const int sum_a = a[0] + a[1] + a[2], sum_b = b[0] + b[1] + b[2];
    if (sum_a < least_sum || sum_b < least_sum) return true;
    for (int i = 0; i < 3; ++i) {
        if (100 * std::abs(a[i] * sum_b - b[i] * sum_a) > hundredths_apart * sum_a * sum_b)
            return false;
    }
    return true;
}

void ImageMeasure::measure_to(const Image& image, const Image& other, int row) {
    const auto width = 4 * static_cast<std::size_t>(image.width);
    const std::size_t begin = static_cast<std::size_t>(rows_) * width;
    const std::size_t end = static_cast<std::size_t>(row) * width;
    for (std::size_t i = begin; i < end; i += 4) {
        int largest = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int apart = std::abs(static_cast<int>(image.rgba[i + channel]) -
                                       static_cast<int>(other.rgba[i + channel]));
            sum_ += apart;
            largest = std::max(largest, apart);
        }
        if (largest > same_within) {
            ++different_;
            wrong_ += std::min(largest, wholly_wrong);
        }
        const std::uint8_t *pixel = image.rgba.data() + i, *wanted = other.rgba.data() + i;
        if (is_black(wanted)) {
            ++black_;
            black_otherwise_ += is_black(pixel) ? 0 : 1;
        } else {
            ++visible_;
            visible_otherwise_ += is_black(pixel) || !has_same_hue(pixel, wanted) ? 1 : 0;
        }
        print_ = hashed(print_, image.rgba.data() + i);
    }
    channels_ += static_cast<std::int64_t>(3 * (end - begin) / 4);
    rows_ = row;
}

ImageDistance ImageMeasure::distance() const {
    if (channels_ == 0) return {};
    const auto part = [](std::int64_t some, std::int64_t all) {
        return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0.0;
    };
    return {static_cast<double>(sum_) / static_cast<double>(channels_), different_,
            static_cast<double>(wrong_) / wholly_wrong,
            part(visible_otherwise_, visible_) + 0.25 * part(black_otherwise_, black_)};
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
    // The new pixels that contain at least a part of an old one.
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
            if (is_same_pixel(&*from, &*pixel(other, column, row))) continue;
            for (int y = first(row, result.height); y <= last(row, result.height); ++y) {
                for (int x = first(column, result.width); x <= last(column, result.width); ++x)
                    std::copy(orange.begin(), orange.end(), pixel(result, x, y));
            }
        }
    }
    return result;
}

Differences differences_of(const Image& a, const Image& b) {
    Differences found{0, {a.width, a.height, 0, 0}};
    Rectangle& area = found.area;
    auto from = a.rgba.begin(), other = b.rgba.begin();
    for (int row = 0; row < a.height; ++row) {
        for (int column = 0; column < a.width; ++column, from += 4, other += 4) {
            if (is_same_pixel(&*from, &*other)) continue;
            ++found.pixels;
            area = {std::min(area.left, column), std::min(area.top, row),
                    std::max(area.right, column + 1), row + 1};
        }
    }
    return found;
}

std::string place_words(const Differences& differences) {
    if (differences.pixels == 0) return "";
    const auto range = [](const char* what, int first, int end) {
        return end - first == 1 ? fmt::format("{} {}", what, first)
                                : fmt::format("{}s {} to {}", what, first, end - 1);
    };
    const Rectangle& area = differences.area;
    return fmt::format("{} in {} and {}.", differences.pixels == 1 ? "It is" : "They are",
                       range("column", area.left, area.right), range("row", area.top, area.bottom));
}

std::uint64_t fingerprint(const Image& image) {
    std::uint64_t hash = no_fingerprint;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4)
        hash = hashed(hash, image.rgba.data() + i);
    return hash;
}

const std::array<OrientationInfo, 4>& orientation_list() {
    static constexpr std::array<OrientationInfo, 4> list{{
        {Orientation::upright, "upright", "upright"},
        {Orientation::mirrored, "mirrored", "Mirrored, with left and right swapped"},
        {Orientation::upside_down, "upside_down", "Upside down"},
        {Orientation::half_turn, "half_turn", "Rotated by half a turn"},
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
