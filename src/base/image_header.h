#pragma once

// What a picture's own words say about it, looked at before any of it is unpacked: stb_image
// believes them, and takes memory for them.

#include <string>
#include <string_view>

namespace rasterwalk {

bool begins_as_png(std::string_view bytes);
bool begins_as_bmp(std::string_view bytes);

/// Throws InputError for a PNG or BMP that is larger than `side` pixels a side or holds more pixels
/// than there is room for, and for one whose data cannot be those of a picture of this size: a BMP
/// that is cut off, a PNG that unpacks to more. What is wrong otherwise is left to stb_image.
/// @param path only used in messages
void check_image_size(std::string_view bytes, const std::string& path, int side);

} // namespace rasterwalk
