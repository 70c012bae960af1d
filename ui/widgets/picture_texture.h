#pragma once

#include <cstdint>

#include <imgui.h>

#include "base/image.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct Ui;

/// A picture, and which part of it is new.
struct NumberedPicture {
    const Image& image;
    std::uint64_t number;     ///< grows whenever the picture changes
    std::uint64_t before = 0; ///< the picture with this number differs from it only in these
                              ///< pixels; 0: nothing is known
    Rectangle changed{};
};

/// Brings the texture up to date with the picture: unchanged if its pixels come out equally large
/// or very large, otherwise resampled. For a large picture it holds what is in view and a little
/// around it; costs that, or the part that has changed.
/// @param low, high of the part in view, screen pixels
void show_texture(Ui& ui, PictureTexture& texture, const NumberedPicture& picture,
                  const PicturePlace& place, ImVec2 low, ImVec2 high);

/// Draws the texture where the picture lies.
void draw_texture(ImDrawList* list, const PictureTexture& texture, const PicturePlace& place);

} // namespace rasterwalk
