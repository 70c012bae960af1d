#pragma once

#include <imgui.h>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// In a pass before the picture: which one it is, in the corner of the canvas.
void draw_pass_title(Ui& ui, ImDrawList* list, const Pane& canvas);

} // namespace rasterwalk
