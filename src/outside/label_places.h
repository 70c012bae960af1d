#pragma once

// Where the names of points in a picture are written, so that none covers another or a line.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "outside/outside_marks.h"

namespace rasterwalk {

/// A part of the picture of the eye, pixels.
struct OutsideBox {
    glm::vec2 low{0.0f}, high{0.0f};
};

/// The first place to try for a text.
enum class LabelSide : std::uint8_t { right, below, above_right };

/// A text to put next to a point.
struct OutsideLabel {
    glm::vec2 point{0.0f}; ///< pixels
    glm::vec2 size{0.0f};  ///< of the text with the room around it, pixels
    float distance = 0.0f; ///< between them, pixels
    LabelSide first = LabelSide::right;
    float line_distance = 0.0f;  ///< distance to keep from lines if possible, pixels
    bool needs_distance = false; ///< if that is impossible, it has no place
};

/// The top left corner of each text: next to its point, within the picture, and over neither an
/// earlier text nor what is taken. A text without such a place, or whose point is outside the
/// picture, has none, so what matters most should come first.
/// @param taken to be kept free of texts
/// @param lines to be kept free if some place allows it
/// @param size  of the picture, pixels
std::vector<std::optional<glm::vec2>> label_places(std::span<const OutsideLabel> labels,
                                                   std::vector<OutsideBox> taken,
                                                   std::span<const OutsideLine> lines,
                                                   glm::vec2 size);

} // namespace rasterwalk
