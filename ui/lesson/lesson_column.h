#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The lesson that is open, the page about the stage on show, or the list of lessons: as a column,
/// or in the drawer that stands instead of strip and inspector.
void draw_lesson_column(Ui& ui, const Area& area);
void draw_lesson_drawer(Ui& ui, const Area& area);

} // namespace rasterwalk
