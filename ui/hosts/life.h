#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// What the window and the page have in common: how they begin, and when they draw.

/// Frames drawn after the last event, until hover, popups and sizes that follow their content are
/// at rest.
inline constexpr int frames_after_event = 3;

/// Takes up what was kept from the last run, and the way on which to go on.
/// @param is_plain nothing was asked for: the program may choose a lesson
void take_up(Ui& ui, bool is_plain);

/// How long after the last frame the next is due, seconds; 0: at once; infinite: when something
/// happens.
/// @param frames_due of the last event
double seconds_to_next_frame(const Ui& ui, int frames_due);

/// What one frame's time counts as, so that nothing leaps after a longer one, seconds.
/// @param passed since the previous frame
/// @param meant_sleep that was meant to lie between the two
float frame_step(float passed, float meant_sleep);

/// Saves what was drawn as "rasterwalk-20260102-030405.png" into the current folder, and says so or
/// what went wrong.
/// @param width,height of the framebuffer, pixels
void save_window_picture(Ui& ui, int width, int height);

} // namespace rasterwalk
