#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The lesson that is open, or the page about the current stage, where there is no room for a
/// column: where the student is, the sentences that count or the question that is open, and the way
/// on. The whole text is in the drawer.
void draw_lesson_strip(Ui& ui, const Area& area);

/// What the strip asks for, screen pixels: two lines of text, or what a question needs. Known from
/// the previous frame.
float lesson_strip_height(const Ui& ui);

} // namespace rasterwalk
