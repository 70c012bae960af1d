#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// Height of the strip under the picture in the overdraw view; 0 in other views.
float overdraw_legend_height(const Ui& ui);

/// The legend of the overdraw view: each number of fragments on a pixel with its colour, or as many
/// of them as there is room for.
void draw_overdraw_legend(Ui& ui, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
