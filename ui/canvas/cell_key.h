#pragma once

#include <string>
#include <vector>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// Are signs or numbers written in the cells at this zoom, so that they need explaining?
bool shows_cell_key(const Ui& ui);

/// What the signs and numbers in the cells mean, on a line: which triangles the signs of the picked
/// pixel belong to, which triangle those of all other pixels, and what the numbers are.
/// @return from the longest form to the shortest
std::vector<std::string> cell_key_forms(const Ui& ui);

/// Draws that line over the lower end of the canvas.
void draw_cell_key(Ui& ui, const Pane& place);

} // namespace rasterwalk
