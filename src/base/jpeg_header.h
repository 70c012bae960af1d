#pragma once

// A JPG's own statements, checked segment by segment before stb_image decodes it: stb_image 2.27
// trusts the tables in a file, and even those that are missing.
//
// Source: ITU-T Recommendation T.81 | ISO/IEC 10918-1, annex B.

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace rasterwalk {

struct JpegHeader {
    glm::ivec2 size{0};  ///< width and height, pixels; 0: none is stated
    std::string problem; ///< why it cannot be decoded: "is cut off."; empty if it can
};

/// Walks over all segments: they must end within the file, every Huffman table must be complete and
/// come before its use, and there must not be more scans than a picture needs.
/// @param bytes begin like a JPG
JpegHeader parse_jpeg_header(std::string_view bytes);

} // namespace rasterwalk
