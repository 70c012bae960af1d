#include "tests/support/compare_images.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace rasterwalk {

namespace {

constexpr std::size_t worst_shown = 8;
constexpr int map_width = 72;
constexpr int map_height = 24;

const std::uint8_t* pixel_at(const Image& image, int column, int row) {
    return image.rgba.data() +
           4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                static_cast<std::size_t>(column));
}

bool contains(const Image& image, int column, int row) {
    return column < image.width && row < image.height;
}

int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int channel = 0; channel < 4; ++channel)
        largest = std::max(largest, std::abs(int{a[channel]} - int{b[channel]}));
    return largest;
}

bool is_worse(const DifferingPixel& a, const DifferingPixel& b) {
    if (a.difference != b.difference) return a.difference > b.difference;
    return a.row != b.row ? a.row < b.row : a.column < b.column;
}

void keep_worst(std::vector<DifferingPixel>& worst, const DifferingPixel& found) {
    if (worst.size() == worst_shown && !is_worse(found, worst.back())) return;
    worst.insert(std::upper_bound(worst.begin(), worst.end(), found, is_worse), found);
    if (worst.size() > worst_shown) worst.pop_back();
}

std::string colour_text(const std::uint8_t* rgba) {
    char text[32];
    std::snprintf(text, sizeof text, "(%3d %3d %3d %3d)", rgba[0], rgba[1], rgba[2], rgba[3]);
    return text;
}

/// One character for the worst pixel of each part of the picture.
std::string heat_map(const Image& actual, const Image& expected, const Tolerance& tolerance) {
    const int columns = std::min(map_width, actual.width);
    const int rows = std::min(map_height, actual.height);
    std::vector<int> worst(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    for (int row = 0; row < actual.height; ++row) {
        for (int column = 0; column < actual.width; ++column) {
            const std::int64_t part_row = std::int64_t{row} * rows / actual.height;
            const std::int64_t part_column = std::int64_t{column} * columns / actual.width;
            int& part = worst[static_cast<std::size_t>(part_row * columns + part_column)];
            part = std::max(part, pixel_difference(pixel_at(actual, column, row),
                                                   pixel_at(expected, column, row)));
        }
    }
    const auto sign = [&](int difference) {
        if (difference == 0) return ' ';
        if (difference <= tolerance.channel) return '.';
        return difference < 32 ? 'o' : difference < 128 ? 'O' : '#';
    };
    const std::string border = "  +" + std::string(static_cast<std::size_t>(columns), '-') + "+\n";
    std::string map = "  Where: . within the tolerance, o beyond, O 32 and more, # 128 and more\n";
    map += border;
    for (int row = 0; row < rows; ++row) {
        map += "  |";
        for (int column = 0; column < columns; ++column)
            map += sign(worst[static_cast<std::size_t>(row * columns + column)]);
        map += "|\n";
    }
    return map + border;
}

} // namespace

ImageDifference compare_images(const Image& actual, const Image& expected,
                               const Tolerance& tolerance) {
    ImageDifference result;
    if (actual.width != expected.width || actual.height != expected.height) {
        result.same_size = false;
        return result;
    }
    if (actual.rgba == expected.rgba) { // most are, and without optimization the rest takes long
        result.is_within_tolerance = true;
        return result;
    }
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < actual.rgba.size(); ++i)
        sum += static_cast<std::uint64_t>(std::abs(int{actual.rgba[i]} - int{expected.rgba[i]}));
    if (!actual.rgba.empty()) {
        result.mean = static_cast<double>(sum) / static_cast<double>(actual.rgba.size());
    }
    for (int row = 0; row < actual.height; ++row) {
        for (int column = 0; column < actual.width; ++column) {
            const int difference =
                pixel_difference(pixel_at(actual, column, row), pixel_at(expected, column, row));
            if (difference == 0) continue;
            if (difference > tolerance.channel) ++result.pixels_beyond;
            keep_worst(result.worst, {column, row, difference});
        }
    }
    if (!result.worst.empty()) result.largest = result.worst.front().difference;
    result.is_within_tolerance =
        result.pixels_beyond <= tolerance.pixels_beyond && result.mean <= tolerance.mean;
    return result;
}

std::string describe_difference(const Image& actual, const Image& expected,
                                const Tolerance& tolerance) {
    const ImageDifference found = compare_images(actual, expected, tolerance);
    char line[256];
    if (!found.same_size) {
        std::snprintf(line, sizeof line, "  The picture is %d x %d pixels, expected %d x %d.\n",
                      actual.width, actual.height, expected.width, expected.height);
        return line;
    }
    if (found.worst.empty()) return "  The pictures are the same.\n";
    std::snprintf(line, sizeof line,
                  "  %d pixels differ by more than %d (%d may), the largest difference is %d,\n"
                  "  the mean difference %.4f (%.4f may be).\n",
                  found.pixels_beyond, tolerance.channel, tolerance.pixels_beyond, found.largest,
                  found.mean, tolerance.mean);
    std::string text = line;
    text += "  The worst pixels, red green blue opacity:\n";
    for (const DifferingPixel& pixel : found.worst) {
        std::snprintf(line, sizeof line, "    (%4d,%4d)  actual ", pixel.column, pixel.row);
        text += line + colour_text(pixel_at(actual, pixel.column, pixel.row));
        text += "  expected " + colour_text(pixel_at(expected, pixel.column, pixel.row)) + "\n";
    }
    return text + heat_map(actual, expected, tolerance);
}

Image difference_image(const Image& actual, const Image& expected, const Tolerance& tolerance) {
    Image image;
    image.width = std::max(actual.width, expected.width);
    image.height = std::max(actual.height, expected.height);
    image.rgba.reserve(4 * static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height));
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            std::array<int, 3> colour{255, 255, 0};
            if (contains(actual, column, row) && contains(expected, column, row)) {
                const std::uint8_t* const a = pixel_at(actual, column, row);
                const int difference = pixel_difference(a, pixel_at(expected, column, row));
                const int grey = (int{a[0]} + int{a[1]} + int{a[2]}) / 12;
                if (difference == 0) {
                    colour = {grey, grey, grey};
                } else if (difference <= tolerance.channel) {
                    colour = {0, 80, 200};
                } else {
                    colour = {std::min(255, 120 + 2 * difference), std::max(0, difference - 32), 0};
                }
            }
            for (const int channel : colour)
                image.rgba.push_back(static_cast<std::uint8_t>(channel));
            image.rgba.push_back(255);
        }
    }
    return image;
}

} // namespace rasterwalk
