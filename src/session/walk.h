#pragma once

#include "inspect/pixel_history.h"
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

/// Lets time run for `seconds`: takes at most one step, so that nothing that was chosen to be seen
/// is skipped however fast the play. Stops at the end.
void advance_play(Session& session, const Timeline& timeline, float seconds);

/// Slowest and fastest play, steps a second.
inline constexpr float slowest_play = 0.5f;
inline constexpr float fastest_play = 60.0f;

} // namespace rasterwalk
