#pragma once

#include <imgui.h>

#include "outside/outside_marks.h"
#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// Draws the marks over the view from outside, and their names.
/// @param pane where it stands; marks count from its corner
void draw_outside_marks(const Ui& ui, ImDrawList* list, const OutsideMarks& marks,
                        const Pane& pane);

} // namespace rasterwalk
