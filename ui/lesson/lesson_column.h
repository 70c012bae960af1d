#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The lesson that is open, the page about the stage on show, or the list of lessons: as a column,
/// or in the drawer over the inspector, where the strip has the way to the next page.
void draw_lesson_column(Ui& ui, const Area& area);
void draw_lesson_drawer(Ui& ui);

} // namespace rasterwalk
