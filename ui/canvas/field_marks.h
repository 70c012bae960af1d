#pragma once

#include <vector>

#include <imgui.h>

#include "ui/canvas/compare_view.h"
#include "ui/canvas/vertex_labels.h"

namespace rasterwalk {

struct Ui;

/// Draws the lines of equal E over the tints of the overlay edge_field.
void draw_field_lines(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high);

/// Draws the overlay weights: the three triangles of the picked pixel in the colours of their
/// edges. Beyond an edge a triangle is only outlined.
void draw_weight_parts(const Ui& ui, ImDrawList* list);

/// Writes E on the lines, in square pixels, and in each triangle the weight of the vertex opposite,
/// where there is room.
/// @param vertices their names stay free
void draw_figure_numbers(const Ui& ui, ImDrawList* list, const Pane& visible,
                         const std::vector<CanvasLabel>& vertices);

/// In the legend: what the overlay weights looks like.
void draw_weights_swatch(ImDrawList* list, ImVec2 at, ImVec2 size);

/// In the legend: chooses the edge whose field is shown.
/// @param height of a line
/// @return where it ends at the right
float draw_field_choice(Ui& ui, ImVec2 at, float height);

} // namespace rasterwalk
