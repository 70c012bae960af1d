#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// A part of the canvas that holds a picture, screen pixels.
struct Pane {
    ImVec2 low, high;

    ImVec2 room() const { return {high.x - low.x, high.y - low.y}; }
};

/// In a canvas lower than this the titles are next to the pictures if they can be, and the scale of
/// the difference says less; design pixels.
inline constexpr float low_canvas = 200.0f;

/// The line above the pictures while two runs are compared: how they are shown, how far apart they
/// are, and the ends of it. If they cannot be compared, it says why.
void draw_compare_bar(Ui& ui);

/// The parts of the canvas for the two pictures: side by side, or one above the other where that
/// leaves them larger. In other views each is the whole canvas.
struct Panes {
    Pane a, b;
};
Panes panes_of(const Ui& ui, const Pane& canvas);

/// The height that the canvas needs so that the pictures compared are not made smaller, screen
/// pixels.
float height_at_full_size(const Ui& ui, float width);

/// The size that two pictures side by side get in a canvas of this size, screen pixels per
/// picture pixel.
float pair_zoom(const Ui& ui, ImVec2 canvas);

/// The divider of the wipe, to be dragged. Call it before the canvas itself, which would take the
/// mouse.
void draw_wipe_handle(Ui& ui, const Pane& canvas);

/// The pictures of both runs in the chosen view, with the marks on them, and their titles.
void draw_compared(Ui& ui, ImDrawList* list, const Pane& canvas);

} // namespace rasterwalk
