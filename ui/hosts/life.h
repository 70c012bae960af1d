#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// What the window and the page share: how they begin, and when they draw.

/// Frames drawn after the last event, until hover, popups and content-dependent sizes are at rest.
inline constexpr int frames_after_event = 3;

/// Takes up what was kept from the last run, including the way to continue on.
/// @param is_plain nothing was requested: the program may choose a lesson
void take_up(Ui& ui, bool is_plain);

/// How long after the last frame the next is due, seconds; 0: immediately; infinite: when something
/// happens.
/// @param frames_due of the last event
double seconds_to_next_frame(const Ui& ui, int frames_due);

/// The time that one frame counts as, so that nothing leaps after a longer one, seconds.
/// @param passed since the previous frame
/// @param meant_sleep the intended pause between the two
float frame_step(float passed, float meant_sleep);

/// Saves what was drawn as "rasterwalk-20260102-030405.png" in the current folder, and says so or
/// what went wrong.
/// @param width,height of the framebuffer, pixels
void save_window_picture(Ui& ui, int width, int height);

} // namespace rasterwalk
