#pragma once

// The format of a picture's bytes. A file's name proves nothing: many are renamed.

#include <cstdint>
#include <string_view>

namespace rasterwalk {

/// The picture formats that are read.
enum class ImageFormat : std::uint8_t {
    none, ///< not in a format that is read
    png,
    bmp,
    jpeg,
    pnm, ///< PGM and PPM, as text (P2, P3) or as bytes (P5, P6)
    tga, ///< has no mark of its own: recognized by a header that makes sense
};

/// How messages list them.
inline constexpr std::string_view image_formats_read = "PNG, JPG, TGA, BMP, PPM or PGM";
/// Those of them that keep every pixel as it was.
inline constexpr std::string_view exact_image_formats = "PNG, TGA, BMP, PPM or PGM";

/// Does the ending of this file name belong to a format that is read?
bool has_image_ending(std::string_view name);
/// The same for those that keep every pixel.
bool has_exact_image_ending(std::string_view name);

/// How much of the beginning of a file is looked at, bytes.
inline constexpr std::size_t image_head_size = 64;

/// The format of the first bytes. Whether the rest is sound is another question.
ImageFormat image_format(std::string_view bytes);

/// The name of a format that is known but not read: "TIFF"; empty: unknown.
std::string_view unread_image_format(std::string_view bytes);

} // namespace rasterwalk
