#pragma once

#include <imgui.h>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

// The titles of two runs that are compared: the letter of each, and how it differs.

/// Height of the titles above the pictures, design pixels.
inline constexpr float title_height = 30.0f;

/// Where the title of a run goes, screen pixels.
struct TitlePlace {
    float left = 0.0f, right = 0.0f, top = 0.0f;
    bool is_at_right = false; ///< it ends at the right; if not, it begins at the left
    bool may_lie_over = true; ///< over a picture that was zoomed in
};

/// The place across this part of the canvas. In a low canvas a title never lies over the picture:
/// there it would hide too much of it.
/// @param left,right,top of the part, screen pixels
TitlePlace place_of_title(const Ui& ui, const Pane& canvas, float left, float right, float top);

/// The letter of a run on a square, then the settings it does not share with the other run, as far
/// as there is a place for them.
void draw_run_title(Ui& ui, ImDrawList* list, bool of_b, const TitlePlace& title);

/// The same for both runs, in the same form: the longest that both have room for.
void draw_two_titles(Ui& ui, ImDrawList* list, const TitlePlace& a, const TitlePlace& b);

/// The titles of both runs, at the left and right of the canvas.
void draw_both_titles(Ui& ui, ImDrawList* list, const Pane& canvas);

/// Is there a place for the letter of a run above or next to a picture that fits into this room?
/// @param zoom screen pixels per picture pixel
bool has_room_for_letter(const Ui& ui, ImVec2 room, float zoom);

} // namespace rasterwalk
