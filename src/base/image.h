#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace rasterwalk {

/// A picture with 8 bits per channel: red, green, blue, opacity, row by row from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 * width * height bytes

    friend bool operator==(const Image&, const Image&) = default;
};

/// A picture as a PNG. Throws InputError if it has no pixels.
std::string png_bytes(const Image& image);

/// Writes a PNG: to a temporary file next to it, which is then renamed. Throws AccessError.
void write_png(const Image& image, const std::string& path);

/// The largest picture file that is read, bytes, and its largest side, pixels.
inline constexpr std::size_t largest_image_file = std::size_t{256} << 20;
inline constexpr int largest_image_side = 4096;

/// Do the bytes begin like a picture in a format that is read (image_format.h)?
bool is_image(std::string_view bytes);

/// The same for a file. False if it cannot be read.
bool is_image_file(const std::string& path);

/// Unpacks a picture whose sides are not larger than this, pixels. Its size and the amount of its
/// data are checked before memory is allocated. Throws an InputError that names the file.
/// @param path only used in messages
Image parse_image(std::string_view bytes, const std::string& path,
                  int largest_side = largest_image_side);

/// The same if every pixel counts: a JPG is refused, since it keeps none exactly.
Image parse_exact_image(std::string_view bytes, const std::string& path);

/// Called with a picture's size before it is unpacked; may throw.
using ImageSizeCheck = std::function<void(glm::ivec2)>;

/// The same from a file. Throws AccessError too.
Image read_image(const std::string& path, int largest_side = largest_image_side,
                 const ImageSizeCheck& check = {});

/// Reads a file that must be a PNG, in the same way.
Image read_png(const std::string& path, int largest_side);

} // namespace rasterwalk
