#pragma once

#include <glm/vec2.hpp>

#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// The picture with zoom, pan, grid, picking and what is drawn over it; the scene from outside; or
/// both.
void draw_canvas(Ui& ui, const Area& area);

/// Does what the canvas shows want the width that a lesson's column would take? Picture and outside
/// do; two pictures side by side do where they would be made smaller without it.
/// @param narrow size of the canvas beside the lesson's column, screen pixels
/// @param wide   its size without that column
bool wants_wide_canvas(const Ui& ui, ImVec2 narrow, ImVec2 wide);

/// A click on a pixel of the picture, wherever it is shown: picks it, its row and its triangle.
void pick_on_picture(Ui& ui, glm::ivec2 pixel, bool triangle_only);

/// Turns the camera by a drag, screen pixels.
void turn_camera(Ui& ui, ImVec2 by);

/// From this zoom on single pixels are worth a grid and marks of their own.
inline constexpr float grid_zoom = 8.0f;

} // namespace rasterwalk
