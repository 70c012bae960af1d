#pragma once

#include <imgui.h>

#include "lessons/lesson.h"
#include "ui/lesson/lesson_state.h"
#include "ui/lesson/page_footer.h"

namespace rasterwalk {

struct Ui;

/// The buttons forward and back and, below them, the button to the whole text and back to the
/// strip: in the same place in both. Returns 1 for forward, -1 for back, 0 if neither was pressed.
/// @param lesson the one shown; null: the page about a stage
/// @param corner at the upper right, screen pixels
int draw_strip_buttons(Ui& ui, const Lesson* lesson, PageFooter pages, ImVec2 corner);

/// Design pixels: margin above and below the strip, and size of its buttons with the gap below
/// them.
inline constexpr float strip_margin_y = 8.0f;
inline constexpr float strip_button_height = 36.0f;
inline constexpr float strip_button_gap = 5.0f;

/// In the window of a text that scrolls: notes what is scrolled away, and does what a key requests.
/// The next page begins with the first line that this one did not show whole.
void scroll_by_key(LessonView& view);

/// In the same window, after the text was drawn: notes which lines of it were shown.
void record_shown_lines(Ui& ui);

/// Only the button to the whole text and back to the strip.
/// @param corner at the upper right, screen pixels
void draw_drawer_button(Ui& ui, ImVec2 corner);

} // namespace rasterwalk
