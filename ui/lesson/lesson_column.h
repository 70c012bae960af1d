#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The open lesson, the page about the current stage, or the list of lessons: as a column, or in
/// the drawer that takes the place of strip and inspector.
void draw_lesson_column(Ui& ui, const Area& area);
void draw_lesson_drawer(Ui& ui, const Area& area);

} // namespace rasterwalk
