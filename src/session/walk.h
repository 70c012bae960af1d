#pragma once

#include "inspect/pixel_history.h"
#include "pipeline/leap.h"
#include "pipeline/timeline.h"
#include "session/session.h"

namespace rasterwalk {

/// To the beginning of the next or previous piece of this size. Stops the play.
void step_forward(Session& session, const Timeline& timeline, Granularity step);
void step_back(Session& session, const Timeline& timeline, Granularity step);

/// Moves the cursor without calling it a visit: scrubbing.
void scrub_to(Session& session, const Cursor& cursor);

/// To a moment, and stops the play; Back returns from it. A cursor that does not exist leads to the
/// next that does.
void go_to(Session& session, const Cursor& cursor);

/// To the moment just after the pixel changes its colour the next time, or just after the change
/// before the last one. Selects the triangle to which the change is due. Returns false, and does
/// nothing, if there is none.
bool next_change(Session& session, const Timeline& timeline, const PixelHistory& history);
bool previous_change(Session& session, const Timeline& timeline, const PixelHistory& history);

/// To the moment just after one fragment of the history, and selects its triangle.
void go_to_entry(Session& session, const Timeline& timeline, const PixelEntry& entry);

/// Starts or stops the play; from the end it starts at the beginning.
void toggle_play(Session& session, const Timeline& timeline);

/// Lets time run for `seconds`, if it does: takes as many steps as the speed says, several at once
/// if they are due, and keeps what is left of one. The first call after the start only shows where
/// it begins. Stops at the end.
/// @param length of the timeline's frame
void advance_play(Session& session, const Timeline& timeline, const FrameLength& length,
                  float seconds);

/// What one call counts as at most, seconds: a play does not leap when the window was hidden.
inline constexpr float longest_play_step = 1.0f;

} // namespace rasterwalk
