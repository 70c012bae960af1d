#pragma once

#include <imgui.h>

#include "ui/app/options_state.h"

namespace rasterwalk {

struct Ui;

/// What all parts of the window have in common: they stay where they are put.
inline constexpr ImGuiWindowFlags panel_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

/// A part of the window, screen pixels.
struct Area {
    ImVec2 position;
    ImVec2 size;
};

/// Where everything is. A pure function of the window's size and the text size.
struct Layout {
    Area menu;      ///< top line
    Area strip;     ///< the stages, the switches and the scene
    Area lesson;    ///< left column; without width if the lesson is a tab of the inspector
    Area canvas;    ///< middle
    Area inspector; ///< right column
    Area transport; ///< time
    Area status;    ///< last line
    bool lesson_is_tab = false;
    float unit = 1.0f; ///< screen pixels per design pixel: the text scale
};

/// The rulers around the canvas: their width, design pixels.
inline constexpr float canvas_ruler = 26.0f;

/// True for a window so small, measured in text, that the bars must make do with less: tabs and the
/// size of a step are lists.
bool is_compact(ImVec2 window, const UiOptions& options);

/// The largest text scale up to the wished one at which the window still holds everything.
float fitting_text_scale(ImVec2 window, float wished);

/// @param transport_height screen pixels
/// @param wide_canvas the lesson makes room for the canvas, as in a small window
Layout compute_layout(ImVec2 window, const UiOptions& options, float transport_height,
                      bool wide_canvas = false);

} // namespace rasterwalk
