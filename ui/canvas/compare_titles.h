#pragma once

#include <imgui.h>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

// The titles of two runs that are compared: the letter of each, and what it has otherwise.

/// Height of the titles above the pictures, design pixels.
inline constexpr float title_height = 30.0f;

/// Where the title of a run has its place, screen pixels.
struct TitlePlace {
    float left = 0.0f, right = 0.0f, top = 0.0f;
    bool is_at_right = false; ///< it ends at the right; or else it begins at the left
    bool may_lie_over = true; ///< over a picture that was zoomed in
};

/// The place across this part of the canvas. In a low canvas a title never lies over the picture:
/// there it would hide too much of it.
/// @param left,right,top of the part, screen pixels
TitlePlace place_of_title(const Ui& ui, const Pane& canvas, float left, float right, float top);

/// The letter of a run on a square, then its settings that the other has not, as far as there is a
/// place for them.
void draw_run_title(Ui& ui, ImDrawList* list, bool of_b, const TitlePlace& title);

/// The same for both runs, in the same form: the longest for which both have room.
void draw_two_titles(Ui& ui, ImDrawList* list, const TitlePlace& a, const TitlePlace& b);

/// The titles of both runs, at the left and at the right of the canvas.
void draw_both_titles(Ui& ui, ImDrawList* list, const Pane& canvas);

/// Is there, above or beside a picture that fits into this room, a place for the letter of its run?
/// @param zoom screen pixels a picture pixel
bool has_room_for_letter(const Ui& ui, ImVec2 room, float zoom);

} // namespace rasterwalk
