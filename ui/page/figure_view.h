#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Figure;
struct Ui;

/// Draws a figure between two corners of the screen, and lets its handles be dragged, or moved with
/// the arrows. Each is entered in Ui::widgets as `figure.` and its setting.
/// @param budget pieces of lines and letters that may still be drawn in this frame; what is drawn
/// is taken off
void show_figure(Ui& ui, const Figure& figure, ImVec2 low, ImVec2 high, int& budget);

/// Pieces of lines and letters that the figures of a page may have together: ImGui's draw lists
/// count their corners in 16 bits.
inline constexpr int most_figure_pieces = 3'000;

} // namespace rasterwalk
