#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// Makes the picture of run A known to the graphics system: in grey where overlays lie on it.
/// @param low, high of the visible part of the canvas
void show_ground(Ui& ui, ImVec2 low, ImVec2 high);

/// Draws the overlays over the picture: one texture, and the lines of the wireframe. Costs what is
/// visible.
void draw_overlays(Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
