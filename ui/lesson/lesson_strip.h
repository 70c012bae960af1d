#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The open lesson, or the page about the current stage, where there is no room for a column: where
/// the student is, the important sentences or the open question, and the button forward. The whole
/// text is in the drawer.
void draw_lesson_strip(Ui& ui, const Area& area);

/// The height that the strip asks for, screen pixels: two lines of text, or what a question needs.
/// Known from the previous frame.
float lesson_strip_height(const Ui& ui);

} // namespace rasterwalk
