#pragma once

#include <string>
#include <vector>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// Do signs or numbers stand in the cells at this zoom, so that they are explained?
bool shows_cell_key(const Ui& ui);

/// What the signs and numbers in the cells mean, on a line: of which triangles the signs of the
/// picked pixel are, of which triangle those of all other pixels, and of what the numbers.
/// @return from the longest form to the shortest
std::vector<std::string> cell_key_forms(const Ui& ui);

/// Draws that line over the lower end of the canvas.
void draw_cell_key(Ui& ui, const Pane& place);

} // namespace rasterwalk
