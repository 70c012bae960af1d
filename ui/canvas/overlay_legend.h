#pragma once

#include <imgui.h>

#include "picture/overlay.h"

namespace rasterwalk {

struct Ui;

/// What the overlay looks like, by the same function that tints the picture. A part of a swatch is
/// drawn from `from` to `to`, shares of its width.
void draw_swatch(const Ui& ui, ImDrawList* list, ImVec2 at, Overlay overlay, float from = 0.0f,
                 float to = 1.0f);
ImVec2 swatch_size(const Ui& ui);

/// The height of the legend of the overlays, below the picture so that it hides nothing of it,
/// screen pixels; 0: none is shown.
/// @param room for the picture and everything below it
float overlay_legend_height(Ui& ui, ImVec2 room);

/// The legends of all overlays from `low` to `high`: what each means, its total, and its value at
/// the pixel pointed at or picked.
/// @param room as for overlay_legend_height()
void draw_overlay_legend(Ui& ui, ImVec2 room, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
