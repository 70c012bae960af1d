#pragma once

#include "ui/widgets/layout.h"

// The bars above and below the canvas.

namespace rasterwalk {

struct Ui;

/// Files, views, scenes, lessons, help; at the right end the settings. In a narrow window the menus
/// are behind a button, with the stages between both ends.
void draw_menu_bar(Ui& ui, const Layout& layout);

/// What the right end of the top line takes in a narrow window of this width, screen pixels.
float menu_end_width(const Ui& ui, float window_width);

/// In an open menu or popup: lists the scenes that come with the program, to be opened.
void draw_scene_list(Ui& ui);

/// The stages that the scene can use, how they are joined, and how far the picture is computed; at
/// the right end the switches that matter and the scene. As much as fits on one line.
void draw_stage_strip(Ui& ui, const Layout& layout);

/// The width of three stages and the list of the others, whichever are shown, screen pixels. If the
/// window is too narrow for that, the strip shows fewer.
float least_strip_width(const Ui& ui);

/// Time: first, back, play, step, last; size of a step; speed; the time lines; the current moment.
void draw_transport(Ui& ui, const Area& area);

/// How high the transport is in a window of this width, screen pixels.
float transport_height(const Ui& ui, float width);

/// What is under the pointer, what is wrong, which rules and which file.
void draw_status_line(Ui& ui, const Area& area);

/// In a lecture, and where every line counts, the status line only appears to say something; the
/// last line of the transport describes the pixel under the pointer.
bool spares_status_line(const Ui& ui);

/// Margin at both ends of a bar, screen pixels.
float bar_margin(const Ui& ui);

/// Gap between the groups of the transport, screen pixels.
float group_gap(const Ui& ui);

} // namespace rasterwalk
