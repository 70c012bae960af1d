#pragma once

#include <imgui.h>

#include "ui/app/options_state.h"

namespace rasterwalk {

struct Ui;

/// What all parts of the window have in common: they cannot be moved.
inline constexpr ImGuiWindowFlags panel_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

/// A part of the window, screen pixels.
struct Area {
    ImVec2 position;
    ImVec2 size;
};

/// Where everything is. A pure function of the window's size, the text size, and what the parts
/// need.
struct Layout {
    Area menu;      ///< top line
    Area strip;     ///< the stages, the switches and the scene; in a narrow window in the top line
    Area lesson;    ///< left column, or a strip above canvas or inspector; no height if a drawer is
                    ///< open
    Area canvas;    ///< middle
    Area inspector; ///< right column
    Area transport; ///< time
    Area status;    ///< last line; without height if there is none
    bool is_narrow = false; ///< the menus are behind a button
    bool lesson_is_strip = false;
    bool lesson_is_at_side = false; ///< the strip is above the inspector, next to the canvas
    float most_strip = 0.0f;        ///< the most height that the strip can have
    float unit = 1.0f;              ///< screen pixels per design pixel: the text scale
};

/// What the parts of the window ask for, screen pixels.
struct LayoutNeeds {
    float transport = 0.0f;    ///< its height
    float lesson_strip = 0.0f; ///< the height of the lesson, if it is a strip
    bool has_drawer = false;   ///< the lesson's whole text replaces strip and inspector
    float menu_end = 0.0f;     ///< width of the right end of the top line, in a narrow window
    bool high_canvas = false;  ///< in a lecture: it has half of the window, from bar to bar
    bool wide_canvas = false;  ///< the lesson makes room for the canvas, as in a narrow window
    bool has_stages = true;    ///< they are in the window
    bool has_status = true;
};

/// True for a window in which, measured in text, a lesson has no room for a column.
bool is_narrow(ImVec2 window, const UiOptions& options);

/// True for a window that is so low, measured in text, that its last line is given up.
bool is_low(ImVec2 window, const UiOptions& options);

/// True for a window in which each line of text costs a line of the table.
bool is_squat(ImVec2 window, const UiOptions& options);

/// True for a window so small, measured in text, that the bars must manage with less, and in a
/// lecture: tabs and the size of a step are lists.
bool is_compact(ImVec2 window, const UiOptions& options);

/// The largest text scale, up to the wished one, at which the window still holds everything.
float fitting_text_scale(ImVec2 window, float wished);

/// The text scale of the lecture mode: as large as possible with canvas and table side by side, and
/// never smaller than the wished one.
float lecture_text_scale(ImVec2 window, float wished);

/// The smallest letters of the lecture mode, screen pixels; smaller only in a window that is too
/// small for any projector.
float least_lecture_letters(ImVec2 window);

Layout compute_layout(ImVec2 window, const UiOptions& options, const LayoutNeeds& needs);

/// The width of the left end of the top line in a narrow window, screen pixels.
float menu_button_width(float unit);

} // namespace rasterwalk
