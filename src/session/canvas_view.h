#pragma once

#include <string>

#include <glm/vec2.hpp>

namespace rasterwalk {

/// How the canvas shows the picture.
struct CanvasView {
    float zoom = 0.0f;            ///< screen pixels a picture pixel; 0: fit
    glm::vec2 centre{0.0f, 0.0f}; ///< picture pixel in the middle of the canvas, when zoom is set
    bool grid = true;             ///< pixel grid from 8x on

    friend bool operator==(const CanvasView&, const CanvasView&) = default;
};

/// A place in the picture, picture pixels: "250.5,131", such that parse_place() reads it back.
std::string to_text(const glm::vec2& place);

inline constexpr float smallest_zoom = 0.25f; ///< screen pixels a picture pixel
inline constexpr float largest_zoom = 64.0f;
inline constexpr float farthest_centre = 1e6f; ///< picture pixels, either sign

} // namespace rasterwalk
