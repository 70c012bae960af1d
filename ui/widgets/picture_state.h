#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "base/image.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// Where the picture lies on the screen: screen = origin + scale * (column, row).
struct PicturePlace {
    ImVec2 origin{0, 0};
    float scale = 1.0f; ///< screen pixels per picture pixel

    /// The middle of a pixel, or a real position counted from pixels' middles.
    ImVec2 middle_of(float column, float row) const {
        return {origin.x + scale * (column + 0.5f), origin.y + scale * (row + 0.5f)};
    }
    ImVec2 middle_of(glm::ivec2 pixel) const {
        return middle_of(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    }
};

/// A part of the picture, in its pixels; `right` and `bottom` lie outside it.
struct PicturePart {
    float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;
};

/// A picture known to the graphics system.
struct PictureTexture {
    ImTextureID id{};
    std::uint64_t number = 0; ///< of the picture that it shows, see Results
    float scale = 0.0f;       ///< that it was resampled for; 1: not resampled
    ImVec2 corner{0, 0};      ///< upper left, picture pixels
    ImVec2 size{0, 0};        ///< in picture pixels
    Rectangle window;         ///< the part that it holds, in pixels of the resampled picture
    Image resampled;          ///< its content, if it was resampled
};

/// A sign on a pixel of a small picture, so that more than its colour sets it apart from others.
enum class SmallSign : std::uint8_t { dot, hollow, stroke };
struct SmallMark {
    int column = 0, row = 0;
    SmallSign sign{};
};

} // namespace rasterwalk
