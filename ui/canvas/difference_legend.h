#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// The scale below the difference picture, with the number under the pointer; in a low canvas only
/// the scale. 0: there is none.
float difference_legend_height(const Ui& ui, float canvas_height);
void draw_difference_legend(Ui& ui, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
