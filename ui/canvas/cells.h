#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "session/canvas_view.h"
#include "ui/canvas/compare_view.h"
#include "ui/canvas/vertex_labels.h"

namespace rasterwalk {

/// The marks in the cells of the picture where they are large: whether each fragment of the
/// triangle shown, and of the picked pixel, passed the depth test, and a number if one is chosen.
/// Costs what is visible.
/// @param seen   the part of the canvas in which the picture can be seen
/// @param labels already drawn there: nothing is drawn under them
void draw_cells(Ui& ui, const Pane& visible_part, const std::vector<CanvasLabel>& labels);

/// The number in a cell of this width; empty if there is none, or no room for it.
/// @param room screen pixels
std::string cell_number(const Ui& ui, glm::ivec2 pixel, float room);

/// Are the signs of pass and fail written in the cells at this zoom?
bool shows_fates(const Ui& ui);

/// Are edge functions or weights written in the cells at this zoom?
bool shows_test_numbers(const Ui& ui);

/// The zoom from which there is room for the signs of pass and fail.
float fates_zoom(const Ui& ui);

/// The zoom from which there is room for these numbers.
float numbers_zoom(const Ui& ui, CellNumbers numbers);

} // namespace rasterwalk
