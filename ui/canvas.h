#pragma once

#include "ui/layout.h"
#include "ui/ui.h"

namespace rasterwalk {

/// The picture with zoom, pan, grid, picking and what is drawn over it.
void draw_canvas(Ui& ui, const Area& area);

/// Enlarges the triangle that the inspector shows, as far as it fits.
void zoom_to_triangle(Ui& ui);

/// From this zoom on single pixels are worth a grid and marks of their own.
inline constexpr float grid_zoom = 8.0f;

} // namespace rasterwalk
