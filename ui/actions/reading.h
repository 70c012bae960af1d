#pragma once

// Files are read beside the window: what was open stays in use until all of it is there.

#include <memory>
#include <string>

#include "session/file_reading.h"

namespace rasterwalk {

struct Ui;

/// Opens a scene, a model, a lesson or a saved view in place of what is shown: at once, if it can
/// be read that soon (see BesideReading), or when it has been read. Throws Error where it is found
/// at once that it cannot be read; everything is then as it was.
void read_and_open(Ui& ui, const std::string& path);

/// What is being read is opened when it is done; another one that is being read is stopped.
void begin_reading(Ui& ui, std::unique_ptr<FileReading> reading);

/// Stops what is being read: what is open stays. Does nothing where nothing is read.
void stop_reading(Ui& ui);

/// Opens what has been read, unless something else was opened meanwhile: that stays. A fault is
/// shown on the sheet for opening. To be called once a frame.
void carry_on_reading(Ui& ui);

bool is_reading(const Ui& ui);

} // namespace rasterwalk
