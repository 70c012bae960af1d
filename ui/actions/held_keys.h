#pragma once

namespace rasterwalk {

struct Ui;

// Keys that move the camera or the light for as long as they are held.

/// Moves what the held keys move, by the time of one frame; a mere touch moves it a little too.
void move_by_held_keys(Ui& ui);

/// Is such a key held, so that the next frame moves on?
bool is_moving_by_key(const Ui& ui);

} // namespace rasterwalk
