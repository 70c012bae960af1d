#include "picture/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterwalk {

namespace {

/// The old columns or rows that a new one covers.
struct Cover {
    int first, last;             ///< old ones, including the last
    float first_part, last_part; ///< covered part of these two; those between are covered whole

    float part_of(int old) const {
        return old == first ? first_part : old == last ? last_part : 1.0f;
    }
};

/// The covers of the new ones from `begin` up to, not including, `end`.
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

using Line = std::vector<float>; ///< per pixel: red, green, blue times opacity; opacity

/// Pixels of one row, four bytes each.
using RowPixels = std::span<const std::uint8_t>;

bool is_opaque(RowPixels row) {
    std::array<std::uint8_t, 4> common{255, 255, 255, 255};
    for (std::size_t i = 0; i < row.size(); i += 4) {
        for (std::size_t c = 0; c < 4; ++c)
            common[c] &= row[i + c];
    }
    return common[3] == 255;
}

/// The weight of a pixel of this opacity, 0 to 255, if this part of it is covered.
float weight_of(float part, std::uint8_t opacity) {
    return part * static_cast<float>(opacity) * (1.0f / 255.0f);
}

/// Adds a part of a row to the line.
void add_row(RowPixels row, float part, Line& line) {
    for (std::size_t i = 0; i < line.size(); i += 4) {
        const float weight = weight_of(part, row[i + 3]);
        for (std::size_t c = 0; c < 3; ++c)
            line[i + c] += weight * static_cast<float>(row[i + c]);
        line[i + 3] += weight;
    }
}

/// The same for an opaque row, where all pixels count the same. What it would add to every opacity
/// goes to `opacity`, so that the compiler can vectorize the loop.
void add_opaque_row(RowPixels row, float part, Line& line, float& opacity) {
    const float weight = weight_of(part, 255);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] += weight * static_cast<float>(row[i]);
    opacity += weight;
}

/// The mean of the rows that one new row covers.
/// @param column of the picture that the line begins with
void add_rows(const Image& image, const Cover& rows, int column, Line& line) {
    const auto pixels = [&](int row) {
        const std::size_t at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width);
        return RowPixels(image.rgba)
            .subspan(4 * (at + static_cast<std::size_t>(column)), line.size());
    };
    bool are_opaque = true;
    for (int row = rows.first; row <= rows.last && are_opaque; ++row)
        are_opaque = is_opaque(pixels(row));
    std::fill(line.begin(), line.end(), 0.0f);
    float opacity = 0.0f;
    for (int row = rows.first; row <= rows.last; ++row) {
        if (are_opaque)
            add_opaque_row(pixels(row), rows.part_of(row), line, opacity);
        else
            add_row(pixels(row), rows.part_of(row), line);
    }
    for (std::size_t i = 3; are_opaque && i < line.size(); i += 4)
        line[i] = opacity;
}

/// One new pixel from the columns of the line that it covers, its numbers 0 to 255.
/// @param from the first of these columns
void mix_pixel(const float* from, const Cover& columns, float area, float* to) {
    std::array<float, 4> sum;
    for (std::size_t c = 0; c < 4; ++c)
        sum[c] = columns.first_part * from[c];
    for (int column = columns.first + 1; column <= columns.last; ++column) {
        from += 4;
        const float part = columns.part_of(column);
        for (std::size_t c = 0; c < 4; ++c)
            sum[c] += part * from[c];
    }
    const float per_opacity = sum[3] > 0.0f ? 1.0f / sum[3] : 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        to[c] = sum[c] * per_opacity;
    to[3] = 255.0f * sum[3] * area;
}

/// A whole line at a time, which is faster than single numbers.
void write_bytes(const Line& line, std::uint8_t* to) {
    for (std::size_t i = 0; i < line.size(); ++i)
        to[i] = static_cast<std::uint8_t>(
            static_cast<std::int32_t>(std::clamp(line[i] + 0.5f, 0.0f, 255.0f)));
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
    Line new_line(4 * columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        add_rows(image, rows[i], begin, line);
        const std::size_t to_row =
            i + static_cast<std::size_t>(changed.top) - static_cast<std::size_t>(window.top);
        std::uint8_t* const to =
            result.rgba.data() + 4 * (to_row * static_cast<std::size_t>(result.width) +
                                      static_cast<std::size_t>(changed.left - window.left));
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const auto first = static_cast<std::size_t>(columns[k].first - begin);
            mix_pixel(line.data() + 4 * first, columns[k], scale * scale, new_line.data() + 4 * k);
        }
        write_bytes(new_line, to);
    }
}

} // namespace rasterwalk
