#include "base/image_format.h"

#include <algorithm>

#include "base/letter_case.h"

namespace rasterwalk {

namespace {

using namespace std::string_view_literals;

/// The mark of a format: the byte it is at, and its bytes.
struct FormatMark {
    std::size_t place;
    std::string_view mark, name;
};

/// How the name of a picture ends, in small letters.
struct ImageEnding {
    std::string_view ending;
    bool is_exact; ///< every pixel is kept
};

constexpr ImageEnding image_endings[] = {
    {".png", true}, {".jpg", false}, {".jpeg", false}, {".tga", true},
    {".bmp", true}, {".ppm", true},  {".pgm", true},
};

/// What the name says about the picture; null: nothing.
const ImageEnding* find_image_ending(std::string_view name) {
    const std::string small = in_small_letters(name);
    const auto* const found =
        std::find_if(std::begin(image_endings), std::end(image_endings),
                     [&](const ImageEnding& of) { return small.ends_with(of.ending); });
    return found != std::end(image_endings) ? found : nullptr;
}

constexpr FormatMark unread_marks[] = {
    {0, "II*\0"sv, "TIFF"},
    {0, "MM\0*"sv, "TIFF"},
    {0, "II+\0"sv, "TIFF"},
    {0, "MM\0+"sv, "TIFF"},
    {0, "DDS ", "DDS"},
    {8, "WEBP", "WebP"},
    {0, "\x76\x2f\x31\x01", "EXR"},
    {0, "#?RADIANCE", "Radiance HDR"},
    {0, "#?RGBE", "Radiance HDR"},
    {0, "GIF8", "GIF"},
    {0, "8BPS", "Photoshop"},
    {0, "\xabKTX", "KTX"},
    {0, "\x13\xab\xa1\x5c", "ASTC"},
    {4, "ftypavif", "AVIF"},
    {4, "ftypavis", "AVIF"},
    {4, "ftypheic", "HEIC"},
    {4, "ftypheix", "HEIC"},
    {4, "ftypmif1", "HEIC"},
    {0, "\0\0\0\x0cjP  "sv, "JPEG 2000"},
    {0, "\xff\x4f\xff\x51", "JPEG 2000"},
    {0, "\0\0\0\x0cJXL "sv, "JPEG XL"},
    {0, "\xff\x0a", "JPEG XL"},
    {0, "gimp xcf", "XCF"},
    {0, "qoif", "QOI"},
    {0, "farbfeld", "farbfeld"},
    {0, "P1", "PBM"},
    {0, "P4", "PBM"},
    {0, "P7\n", "PAM"},
    {0, "PF\n", "PFM"},
    {0, "Pf\n", "PFM"},
    {0, "\x0a\x05\x01\x08", "PCX"},
    {0, "\0\0\x01\0"sv, "ICO"},
    {0, "\x01\xda", "SGI"},
    {0, "<svg", "SVG"},
};

unsigned byte_of(std::string_view bytes, std::size_t place) {
    return place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0u;
}

bool begins_as_pnm(std::string_view bytes) {
    constexpr std::string_view kinds = "2356", blanks = " \t\r\n\v\f#";
    return bytes.size() > 2 && bytes[0] == 'P' && kinds.find(bytes[1]) != kinds.npos &&
           blanks.find(bytes[2]) != blanks.npos;
}

/// Truevision TGA File Format Specification, version 2.0, 1991: the first 18 bytes.
bool begins_as_tga(std::string_view bytes) {
    if (bytes.size() < 18) return false;
    const unsigned has_palette = byte_of(bytes, 1), bits = byte_of(bytes, 16);
    const unsigned kind = byte_of(bytes, 2) & ~8u; // 8: packed
    const bool is_kind =
        byte_of(bytes, 2) < 12 &&
        (has_palette == 1 ? kind == 1 : has_palette == 0 && (kind == 2 || kind == 3));
    const bool has_size = (byte_of(bytes, 12) | byte_of(bytes, 13)) != 0 &&
                          (byte_of(bytes, 14) | byte_of(bytes, 15)) != 0;
    const bool are_bits = bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32;
    return is_kind && has_size && are_bits && byte_of(bytes, 17) >> 6 == 0;
}

} // namespace

bool has_image_ending(std::string_view name) {
    return find_image_ending(name) != nullptr;
}

bool has_exact_image_ending(std::string_view name) {
    const ImageEnding* const found = find_image_ending(name);
    return found != nullptr && found->is_exact;
}

ImageFormat image_format(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return ImageFormat::png;
    if (bytes.starts_with("\xff\xd8\xff")) return ImageFormat::jpeg;
    if (bytes.starts_with("BM")) return ImageFormat::bmp;
    if (begins_as_pnm(bytes)) return ImageFormat::pnm;
    if (unread_image_format(bytes).empty() && begins_as_tga(bytes)) return ImageFormat::tga;
    return ImageFormat::none;
}

std::string_view unread_image_format(std::string_view bytes) {
    const auto found =
        std::find_if(std::begin(unread_marks), std::end(unread_marks), [&](const FormatMark& of) {
            return bytes.size() > of.place && bytes.substr(of.place).starts_with(of.mark);
        });
    return found != std::end(unread_marks) ? found->name : std::string_view{};
}

} // namespace rasterwalk
