#pragma once

#include <imgui.h>

#include "ui/ui.h"

namespace rasterwalk {

/// Draws over the picture: grid and numbers, the triangle's true edges, vertices, edge samples up
/// to the cursor, row ends, the current piece, what is picked and pointed at. Costs what is
/// visible.
void draw_canvas_marks(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high);

/// Takes hold of a vertex of the bench triangle under the pointer and moves it with it. True while
/// a vertex is held.
bool drag_bench_vertex(Ui& ui);

} // namespace rasterwalk
