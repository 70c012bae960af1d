#pragma once

// PGM and PPM, the pictures that courses write: numbers as text (P2, P3) or as bytes (P5, P6).
//
// Source: the pages pgm(5) and ppm(5) of Netpbm.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "base/image.h"

namespace rasterwalk {

/// The part before the samples.
struct PnmHeader {
    glm::ivec2 size{0};    ///< width and height, pixels
    int largest = 255;     ///< a sample of full light, 1 to 65535
    int channels = 3;      ///< 1 (PGM) or 3 (PPM)
    bool is_text = false;  ///< P2 and P3
    std::size_t begin = 0; ///< of the samples

    /// The fewest bytes its samples can take.
    std::size_t fewest_bytes() const;
};

/// None if it is incomplete, or a number in it is out of range.
/// @param bytes begin like a PGM or PPM
std::optional<PnmHeader> parse_pnm_header(std::string_view bytes);

/// The picture; a sample s of `largest` becomes the byte nearest to 255 s / largest. None if a
/// sample is missing or larger than `largest`.
std::optional<Image> parse_pnm(std::string_view bytes, const PnmHeader& header);

} // namespace rasterwalk
