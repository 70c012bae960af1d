#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The picture with zoom, pan, grid, picking and what is drawn over it; the scene from outside; or
/// both.
void draw_canvas(Ui& ui, const Area& area);

/// Does the canvas need the width that a lesson's column would take? Picture and outside do where
/// they have too little room without it; two pictures side by side where they would be made
/// smaller.
/// @param narrow size of the canvas next to the lesson's column, screen pixels
/// @param wide   its size without that column
bool wants_wide_canvas(const Ui& ui, ImVec2 narrow, ImVec2 wide);

} // namespace rasterwalk
