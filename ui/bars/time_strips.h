#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// How high the time lines are, screen pixels.
/// @param has_window whether the second one, which enlarges a part, is shown
float time_strips_height(const Ui& ui, bool has_window);

/// The whole frame as a line, with the differences of two runs above it; below it the part in its
/// bracket, enlarged: what a triangle is made of, in the colours of its edges.
void draw_time_strips(Ui& ui, ImVec2 at, float width, bool has_window);

} // namespace rasterwalk
