#include "picture/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rasterwalk {

namespace {

/// What one new column or row covers of the old ones.
struct Cover {
    int first, last;             ///< old ones, last included
    float first_part, last_part; ///< of these two, how much; those between are covered whole
};

/// For the new ones from `begin` up to, not including, `end`.
std::vector<Cover> covers_of(int side, int begin, int end, float scale) {
    std::vector<Cover> covers;
    covers.reserve(static_cast<std::size_t>(end - begin));
    const double step = 1.0 / static_cast<double>(scale);
    for (int i = begin; i < end; ++i) {
        const double from = i * step, to = std::min((i + 1) * step, static_cast<double>(side));
        Cover c{};
        c.first = std::min(static_cast<int>(from), side - 1);
        c.last = std::clamp(static_cast<int>(std::ceil(to)) - 1, c.first, side - 1);
        c.first_part = static_cast<float>(std::min(to, c.first + 1.0) - from);
        c.last_part = c.last > c.first ? static_cast<float>(to - c.last) : 0.0f;
        covers.push_back(c);
    }
    return covers;
}

using Line = std::vector<float>; ///< red, green, blue times opacity, opacity: four numbers a pixel

/// Adds a part of a row of the picture, from this column on, to the line.
void add_row(const Image& image, int row, int column, float part, Line& line) {
    const std::uint8_t* from = image.rgba.data() + 4 * (static_cast<std::size_t>(row) *
                                                            static_cast<std::size_t>(image.width) +
                                                        static_cast<std::size_t>(column));
    for (std::size_t i = 0; i < line.size(); i += 4) {
        const float opacity = part * static_cast<float>(from[i + 3]) * (1.0f / 255.0f);
        for (std::size_t c = 0; c < 3; ++c)
            line[i + c] += opacity * static_cast<float>(from[i + c]);
        line[i + 3] += opacity;
    }
}

std::uint8_t as_byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
}

/// One new pixel from the columns of the line that it covers.
/// @param begin the column that the line begins with
void write_pixel(const Line& line, int begin, const Cover& cover, float area, std::uint8_t* to) {
    float sum[4] = {0, 0, 0, 0};
    for (int column = cover.first; column <= cover.last; ++column) {
        const float part = column == cover.first  ? cover.first_part
                           : column == cover.last ? cover.last_part
                                                  : 1.0f;
        const float* const from = line.data() + 4 * static_cast<std::size_t>(column - begin);
        for (int c = 0; c < 4; ++c)
            sum[c] += part * from[c];
    }
    const float per_opacity = sum[3] > 0.0f ? 1.0f / sum[3] : 0.0f;
    for (int c = 0; c < 3; ++c)
        to[c] = as_byte(sum[c] * per_opacity);
    to[3] = as_byte(255.0f * sum[3] * area);
}

} // namespace

int resampled_side(int side, float scale) {
    return std::max(1, static_cast<int>(std::ceil(static_cast<float>(side) * scale - 1e-3f)));
}

Image resampled(const Image& image, float scale) {
    Image result;
    if (image.width <= 0 || image.height <= 0) return result;
    result.width = resampled_side(image.width, scale);
    result.height = resampled_side(image.height, scale);
    result.rgba.resize(4 * static_cast<std::size_t>(result.width) *
                       static_cast<std::size_t>(result.height));
    const Rectangle whole{0, 0, result.width, result.height};
    resample_part(image, scale, whole, whole, result);
    return result;
}

void resample_part(const Image& image, float scale, const Rectangle& window,
                   const Rectangle& changed, Image& result) {
    if (is_empty(changed)) return;
    const std::vector<Cover> columns = covers_of(image.width, changed.left, changed.right, scale);
    const std::vector<Cover> rows = covers_of(image.height, changed.top, changed.bottom, scale);
    const int begin = columns.front().first, end = columns.back().last + 1;
    Line line(4 * static_cast<std::size_t>(end - begin));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Cover& cover = rows[i];
        std::fill(line.begin(), line.end(), 0.0f);
        add_row(image, cover.first, begin, cover.first_part, line);
        for (int row = cover.first + 1; row < cover.last; ++row)
            add_row(image, row, begin, 1.0f, line);
        if (cover.last > cover.first) add_row(image, cover.last, begin, cover.last_part, line);
        const std::size_t to_row =
            i + static_cast<std::size_t>(changed.top) - static_cast<std::size_t>(window.top);
        std::uint8_t* to =
            result.rgba.data() + 4 * (to_row * static_cast<std::size_t>(result.width) +
                                      static_cast<std::size_t>(changed.left - window.left));
        for (const Cover& column : columns) {
            write_pixel(line, begin, column, scale * scale, to);
            to += 4;
        }
    }
}

} // namespace rasterwalk
