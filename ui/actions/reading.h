#pragma once

// Files are read in the background: what was open stays in use until all of it is there.

#include <memory>
#include <string>

#include "session/file_reading.h"

namespace rasterwalk {

struct Ui;

/// Opens a scene, a model, a lesson or a saved view in place of what is shown: immediately, if it
/// can be read that soon (see BackgroundLoad), or when it has been read. Throws Error if it is
/// clear immediately that it cannot be read; everything is then unchanged.
void read_and_open(Ui& ui, const std::string& path);

/// Opens what is being read when it is done; any earlier reading is stopped.
void begin_reading(Ui& ui, std::unique_ptr<FileReading> reading);

/// Stops what is being read: what is open stays. Does nothing if nothing is being read.
void stop_reading(Ui& ui);

/// Opens what has been read, unless something else was opened in the meantime: that stays. A fault
/// is shown on the sheet for opening. To be called once a frame.
void poll_background_load(Ui& ui);

bool is_reading(const Ui& ui);

} // namespace rasterwalk
