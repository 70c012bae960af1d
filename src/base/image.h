#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A picture of 8 bits a channel: red, green, blue, opacity, row by row from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 * width * height bytes

    friend bool operator==(const Image&, const Image&) = default;
};

/// Writes a PNG: to a temporary file beside it, then renamed. Throws AccessError.
void write_png(const Image& image, const std::string& path);

/// The largest file of a picture that is read, bytes.
inline constexpr std::size_t largest_image_file = std::size_t{256} << 20;

/// Do the bytes begin as a PNG or BMP does?
bool is_image(std::string_view bytes);

/// Does the file begin as a PNG or BMP does? False if it cannot be read.
bool is_image_file(const std::string& path);

/// Reads a PNG whose sides are not larger than this, pixels. Throws AccessError or InputError.
Image read_png(const std::string& path, int largest_side);

/// Unpacks a PNG or BMP of at most 16384 pixels a side. Its size, and how much data belongs to it,
/// are looked at before memory is taken. Throws InputError; `path` is only used in messages.
Image parse_image(std::string_view bytes, const std::string& path);

/// The same from a file. Throws AccessError too.
Image read_image(const std::string& path);

} // namespace rasterwalk
