#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// Makes the picture of run A known to the graphics system: in grey where overlays lie on it.
void show_ground(Ui& ui);

/// The button in the canvas header that opens the list of overlays.
/// @param narrow a sign in place of the word, for small windows
void draw_overlay_button(Ui& ui, bool narrow);
float overlay_button_width(const Ui& ui, bool narrow);

/// Draws the overlays over the picture: one texture, and the lines of the wireframe. Costs what is
/// visible.
void draw_overlays(Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high);

/// The legends of all overlays on a card in the corner of the canvas that spans from `low` to
/// `high`: what each means, its total, and its value at the pixel pointed at or picked.
void draw_overlay_legend(Ui& ui, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
