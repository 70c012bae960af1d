#pragma once

#include "ui/widgets/layout.h"

// The bars above and below the canvas.

namespace rasterwalk {

struct Ui;

/// Scene, settings, views, help.
void draw_menu_bar(Ui& ui, const Area& area);

/// The stages in order and the two switches, in as many lines as the width asks for.
void draw_stage_strip(Ui& ui, const Area& area);
int stage_strip_lines(const Ui& ui, float width);

/// Time: first, back, play, step, last; size of a step; speed; the time lines; where it stands.
void draw_transport(Ui& ui, const Area& area);

/// How high the transport is in a window of this width, screen pixels.
float transport_height(const Ui& ui, float width);

/// What is under the pointer, what is out of order, which rules and which file.
void draw_status_line(Ui& ui, const Area& area);

/// Room at both ends of a bar, screen pixels.
float bar_margin(const Ui& ui);

} // namespace rasterwalk
