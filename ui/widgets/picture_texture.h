#pragma once

#include <cstdint>

#include <imgui.h>

#include "base/image.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct Ui;

/// Brings the texture up to date with the picture, for being shown at `scale`: as it is where its
/// pixels come out equally large or very large, or else resampled.
/// @param number grows whenever the picture changes
void show_texture(Ui& ui, PictureTexture& texture, const Image& image, std::uint64_t number,
                  float scale);

/// Draws the texture where the picture lies.
void draw_texture(ImDrawList* list, const PictureTexture& texture, const PicturePlace& place);

} // namespace rasterwalk
