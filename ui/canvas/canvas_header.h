#pragma once

#include <string_view>

namespace rasterwalk {

struct Ui;

/// The line above the canvas: what it shows, which plane and which layers, and how large.
void draw_canvas_header(Ui& ui, float right_edge);

/// Is a widget with this name in that line?
bool is_in_canvas_header(std::string_view widget);

} // namespace rasterwalk
