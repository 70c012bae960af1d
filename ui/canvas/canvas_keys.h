#pragma once

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// What keys do while the picture has the keyboard: the arrows pick the next pixel, plus and minus
/// zoom about the picked one.
/// @param pane of the picture of run A
/// @param seen the part of it that nothing covers: the picked pixel is brought there
void handle_canvas_keys(Ui& ui, const Pane& pane, const Pane& seen);

} // namespace rasterwalk
