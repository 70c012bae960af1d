#pragma once

#include <imgui.h>

namespace rasterwalk {

struct Ui;

// The current moment in words: the last line of the transport.

/// What was drawn last, what comes next and, with a pixel picked or room to spare, the buttons for
/// its changes on one line; in a lecture those for the picture. If there is no status line, the
/// pixel under the pointer takes the place of the words.
void draw_moment_line(Ui& ui, ImVec2 at, float room);

// The same in two halves, for when they are not side by side.

/// What was drawn last, as far as there is room; returns its width.
float draw_done_moment(Ui& ui, ImVec2 at, float room);

/// What comes next and, except in a lecture, the buttons for the changes of a pixel at the right
/// end.
void draw_next_moment(Ui& ui, ImVec2 at, float room);

} // namespace rasterwalk
