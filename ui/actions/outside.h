#pragma once

#include "session/canvas_view.h"

namespace rasterwalk {

struct Ui;

/// What the canvas shows now.
CanvasShows shown_on_canvas(const Ui& ui);

/// Shows this on the canvas; a scene without a camera has only its picture to show, and the status
/// line says so.
void show_on_canvas(Ui& ui, CanvasShows shows);

/// Shows this, or the picture again if it is shown already.
void switch_canvas(Ui& ui, CanvasShows shows);

/// Switches the view from outside between looking through the scene's camera and from outside.
void switch_camera_view(Ui& ui);

/// Turns the view from outside about its middle, radians.
void turn_outside(Ui& ui, float yaw, float pitch);

} // namespace rasterwalk
