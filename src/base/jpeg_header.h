#pragma once

// What a JPG says about itself, segment by segment, before stb_image decodes it: stb_image 2.27
// trusts the tables that a file gives, and those that it does not give.
//
// Source: ITU-T Recommendation T.81 | ISO/IEC 10918-1, annex B.

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace rasterwalk {

struct JpegHeader {
    glm::ivec2 size{0};  ///< width and height, pixels; 0: none is stated
    std::string trouble; ///< why it is not to be decoded: "is cut off."; empty if it is
};

/// Walks over all segments: they end within the file, every Huffman table is whole and there before
/// it is used, and the scans are not more than a picture needs.
/// @param bytes begin as a JPG does
JpegHeader parse_jpeg_header(std::string_view bytes);

} // namespace rasterwalk
