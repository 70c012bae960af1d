#pragma once

#include <glm/vec2.hpp>
#include <imgui.h>

#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// What the mouse does on the picture, which must be the last item: points at a pixel, picks it,
/// zooms, drags the picture or a vertex of the bench, turns the camera.
/// @param pane of the picture of run A
void handle_canvas_pointer(Ui& ui, const Pane& pane);

/// A click on a pixel of the picture, wherever it is shown: picks it, its row and its triangle.
void pick_on_picture(Ui& ui, glm::ivec2 pixel, bool triangle_only);

/// Turns the camera by a drag, screen pixels.
void turn_camera(Ui& ui, ImVec2 by);

} // namespace rasterwalk
