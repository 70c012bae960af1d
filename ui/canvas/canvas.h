#pragma once

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The picture with zoom, pan, grid, picking and what is drawn over it.
void draw_canvas(Ui& ui, const Area& area);

/// From this zoom on single pixels are worth a grid and marks of their own.
inline constexpr float grid_zoom = 8.0f;

} // namespace rasterwalk
