#pragma once

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// Brings the pictures up to date with the scene of the session, for this size on the screen. A
/// scene of so many triangles that it could not be drawn at once has none.
/// @param side screen pixels, 1 or more
void renew_stage_pictures(Ui& ui, int side);

} // namespace rasterwalk
