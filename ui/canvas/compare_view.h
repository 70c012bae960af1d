#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// A part of the canvas in which a picture stands, screen pixels.
struct Pane {
    ImVec2 low, high;

    ImVec2 room() const { return {high.x - low.x, high.y - low.y}; }
};

/// In a canvas lower than this the titles stand beside the pictures if they can, and the scale of
/// the difference says less; design pixels.
inline constexpr float low_canvas = 200.0f;

/// The line above the pictures while two runs are compared: in which way they are shown, how far
/// they lie apart, and the ends of it. Where they cannot be compared it says why.
void draw_compare_bar(Ui& ui);

/// The parts of the canvas in which the two pictures stand: beside each other, or one above the
/// other where that leaves them larger. Otherwise each is the whole canvas.
struct Panes {
    Pane a, b;
};
Panes panes_of(const Ui& ui, const Pane& canvas);

/// The height that the canvas needs so that what is compared is not made smaller, screen pixels.
float height_at_full_size(const Ui& ui, float width);

/// How large the pictures come out that stand side by side in a canvas of this size, screen pixels
/// a picture pixel.
float pair_zoom(const Ui& ui, ImVec2 canvas);

/// The divider of the wipe, to be dragged. To be called before the canvas itself, which else would
/// take the mouse.
void draw_wipe_handle(Ui& ui, const Pane& canvas);

/// The pictures of both runs in the way chosen, with the marks on them, and their titles.
void draw_compared(Ui& ui, ImDrawList* list, const Pane& canvas);

} // namespace rasterwalk
