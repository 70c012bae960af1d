#pragma once

// The passes before the picture, next to the line of the frame: one block for each.

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// The room that the blocks take of a time line, screen pixels: in front of the line and behind it.
struct PassRoom {
    float before = 0.0f;
    float after = 0.0f; ///< of the block that leads back to the picture, while a pass is shown
};

/// None if the picture has no passes before it, or if too little would be left of the line.
/// @param width of line and blocks together, screen pixels
PassRoom pass_room(const Ui& ui, float width);

/// The blocks, from `top` to `bottom`.
/// @param left where the first one begins
/// @param right where the one behind the line ends
void draw_pass_blocks(Ui& ui, const PassRoom& room, ImVec2 left_top, ImVec2 right_bottom);

} // namespace rasterwalk
