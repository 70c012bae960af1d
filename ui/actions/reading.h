#pragma once

// Large models are read beside the window: what was open stays in use until all of it is there.

#include <string>

namespace rasterwalk {

struct Ui;

/// Begins to read a scene file beside the window; another one that is being read is stopped.
void begin_reading(Ui& ui, const std::string& path);

/// Stops what is being read: what is open stays. Does nothing where nothing is read.
void stop_reading(Ui& ui);

/// Opens what has been read, unless something else was opened meanwhile: that stays. A fault is
/// shown on the sheet for opening. To be called once a frame.
void carry_on_reading(Ui& ui);

bool is_reading(const Ui& ui);

} // namespace rasterwalk
