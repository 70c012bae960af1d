#pragma once

#include "session/canvas_view.h"

namespace rasterwalk {

struct Ui;

/// What the canvas shows now.
CanvasShows shown_on_canvas(const Ui& ui);

/// Shows this on the canvas; of a scene without a camera only its picture can be shown, and the
/// status line says so.
void show_on_canvas(Ui& ui, CanvasShows shows);

/// Shows this, or the picture again if it is shown already.
void switch_canvas(Ui& ui, CanvasShows shows);

/// The view from outside looks through the scene's camera, or again from outside.
void switch_camera_view(Ui& ui);

/// Turns the view from outside about what is in its middle, radians.
void turn_outside(Ui& ui, float yaw, float pitch);

} // namespace rasterwalk
