#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// Height of the strip under the picture in the depth view, for a canvas of this height; 0 in other
/// views.
float depth_legend_height(const Ui& ui, float canvas_height);

/// The legend of the depth view: a histogram of the stored 1/z in the colours of the view, the ends
/// of the range as handles to drag, and numbers.
void draw_depth_legend(Ui& ui, ImVec2 low, ImVec2 high);

} // namespace rasterwalk
