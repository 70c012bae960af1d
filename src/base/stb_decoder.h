#pragma once

// stb_image, compiled for hostile files: memory starts as zeros, so a picture whose data end early
// is the same each time, and a check that fails inside it throws instead of ending the program.

#include <cstddef>
#include <string>
#include <string_view>

#include "base/image.h"

namespace rasterwalk {

/// Unpacks a PNG, BMP, TGA or JPG for which stated_size() has not thrown (image_header.h).
/// @return why it could not: "bad huffman code"; empty if it could
std::string decode_image(std::string_view bytes, Image& image);

/// What decode_zlib() returns if there is no room for all of it.
inline constexpr std::string_view zlib_has_more = "output buffer limit";

/// Unpacks zlib data into `room` bytes, and discards them.
/// @return why it could not; empty if it could
std::string decode_zlib(std::string_view data, std::size_t room);

} // namespace rasterwalk
