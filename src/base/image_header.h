#pragma once

// A picture's header, checked before any of it is unpacked: stb_image trusts it, and allocates
// memory accordingly.

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace rasterwalk {

/// The width and height that a picture states, pixels: each at least 1. Throws InputError for a
/// format that is not read, if they are more than `largest_side`, and if the bytes cannot hold such
/// a picture: a block or the rows of pixels would reach beyond the end of the file.
/// @param path only used in messages
glm::ivec2 stated_size(std::string_view bytes, const std::string& path, int largest_side);

/// The compressed data of a PNG for which stated_size() does not throw: of all its blocks.
std::string png_data(std::string_view bytes);

/// How many bytes these data unpack to: the rows of all pixels, each with its filter.
std::size_t png_row_bytes(std::string_view bytes);

} // namespace rasterwalk
