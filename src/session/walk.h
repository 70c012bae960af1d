#pragma once

#include "inspect/pixel_history.h"
#include "pipeline/stepping.h"
#include "pipeline/timeline.h"
#include "session/session.h"

namespace rasterwalk {

// A timeline is that of the frame shown, which may be a pass before the picture. Walking leads from
// one pass into the next; each stands still at its end, where all that it has drawn is there to be
// seen.

/// Goes to the beginning of the next or previous piece of this size. Stops playback.
void step_forward(Session& session, const Timeline& timeline, Granularity step);
void step_back(Session& session, const Timeline& timeline, Granularity step);

/// Moves the cursor without counting as a visit: scrubbing.
/// @param cursor with its pass
void scrub_to(Session& session, const Cursor& cursor);

/// Goes to a moment, and stops playback; Back returns from it. A cursor that does not exist leads
/// to the next one that does.
/// @param cursor with its pass
void go_to(Session& session, const Cursor& cursor);

/// The same in the frame of a timeline.
void go_to(Session& session, const Timeline& timeline, const Cursor& cursor);

/// Goes to the moment just after the one that wrote a texel of the shadow map, in the pass of its
/// face, and picks it there; to the end of that pass if nothing did. The run must have a map.
/// @param face 0 to shadow_face_count - 1
void go_to_texel(Session& session, int face, const glm::ivec2& texel);

/// Goes to the beginning of the pass shown, and from there to that of the first one; or to the end
/// of the pass, and from there to that of the picture.
void go_to_beginning(Session& session, const Timeline& timeline);
void go_to_end(Session& session, const Timeline& timeline);

/// Goes to the moment just after the pixel's next or previous change of colour; a change that the
/// cursor is already just after is not the previous one. Selects the triangle that made the change.
/// Returns false, and does nothing, if there is none.
bool next_change(Session& session, const Timeline& timeline, const PixelHistory& history);
bool previous_change(Session& session, const Timeline& timeline, const PixelHistory& history);

/// Goes to the moment just after one fragment of the history, and selects its triangle.
void go_to_entry(Session& session, const Timeline& timeline, const PixelEntry& entry);

/// Starts or stops playback; from the end it starts at the beginning.
void toggle_play(Session& session, const Timeline& timeline);

/// During playback, advances time by `seconds`: takes as many steps as the speed says, possibly
/// several, and keeps the remaining part of one. The first call after the start does not move the
/// cursor. Stops at the end, and where a student's program that is run B first puts another pixel,
/// which a notice says.
/// @param length of the timeline's frame
void advance_play(Session& session, const Timeline& timeline, const FrameLength& length,
                  float seconds);

/// The most that one call counts as, seconds, so that playback does not leap after the window was
/// hidden.
inline constexpr float longest_play_step = 1.0f;

} // namespace rasterwalk
