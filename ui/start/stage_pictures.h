#pragma once

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// Sets the light that shows most, if the presets have it: the lab's own leaves the room dark.
void light_up(const Session& session, Settings& settings);

/// Brings the pictures up to date with the scene of the session, for this size on the screen. A
/// scene with too many triangles to be drawn immediately has none.
/// @param side screen pixels, 1 or more
void renew_stage_pictures(Ui& ui, int side);

} // namespace rasterwalk
