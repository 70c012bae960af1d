#pragma once

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// Draws the page, if it is open, over everything between menu and status line, and takes its keys:
/// Enter goes the chosen way, Escape leaves the page.
void draw_start_page(Ui& ui, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
