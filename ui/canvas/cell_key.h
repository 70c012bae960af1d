#pragma once

#include <string>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// Do signs or numbers stand in the cells at this zoom, so that they are explained?
bool shows_cell_key(const Ui& ui);

/// What the signs and numbers in the cells mean, on a line: of which triangles the signs of the
/// picked pixel are, of which triangle those of all other pixels, and of what the numbers.
/// @param is_short for where there is little room
std::string cell_key_text(const Ui& ui, bool is_short);

/// Draws that line over the lower end of the canvas.
void draw_cell_key(Ui& ui, const Pane& place);

} // namespace rasterwalk
