#pragma once

#include <imgui.h>

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// Sets the light that shows most, if the presets have it: the lab's own leaves the room dark.
void light_up(const Session& session, Settings& settings);

/// Brings the pictures up to date with the scene of the session, for this size on the screen. A
/// scene with too many triangles to be drawn immediately has none.
/// @param side screen pixels, 1 or more
void renew_stage_pictures(Ui& ui, int side);

/// What a choice leads to, in three small pictures with a word below each: the frame while it is
/// drawn, or a wrong picture next to the right one. They end at the lower edge of the place;
/// nothing is shown if they would be too small or reach above it, or if the scene has nothing to
/// show.
/// @param low, high of the place, screen pixels
/// @param most how high a picture may be, screen pixels: the same for all choices
void draw_start_pictures(Ui& ui, StartChoice choice, ImVec2 low, ImVec2 high, float most);

} // namespace rasterwalk
