#pragma once

#include <string>

#include <imgui.h>

#include "pipeline/cursor.h"
#include "ui/canvas/compare_view.h"

namespace rasterwalk {

struct Ui;

/// The scene from outside in a part of the canvas: turned by dragging, nearer and farther by the
/// wheel; a click picks a triangle of the scene, or a pixel of the picture on its pane.
void draw_outside(Ui& ui, const Pane& pane);

/// Gives back the memory of the view from outside if it has not been shown for half a minute: in a
/// large window that is more than 100 MB.
void leave_outside(Ui& ui);

/// Is any of the view from outside still to be drawn?
bool is_outside_working(const Ui& ui);

/// Which triangles are still to come at a moment, and therefore darker; empty if none are.
/// @param triangles of the scene
std::string coming_words(int triangles, const Cursor& cursor);

/// The parts of the canvas for the picture and the scene from outside while both are shown: side by
/// side, or one above the other where that makes them larger.
struct CanvasHalves {
    Pane picture, outside;
};
CanvasHalves canvas_halves(const Ui& ui, const Pane& canvas);

} // namespace rasterwalk
