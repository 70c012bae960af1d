#pragma once

#include <imgui.h>

#include "outside/outside_marks.h"
#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// Draws the marks over the view from outside, and those of their names for which there is room.
/// @param pane   where it is; marks count from its corner
/// @param top    height of the text above, screen pixels: no name is drawn there
/// @param bottom height of the text below
void draw_outside_marks(const Ui& ui, ImDrawList* list, const OutsideMarks& marks, const Pane& pane,
                        float top, float bottom);

} // namespace rasterwalk
