#pragma once

// How the program begins: the three choices of the start page, and which of them is taken.

#include <string>

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// How the program begins when the command line names nothing: the first time with the start page;
/// later where the student stopped, along the way they chose. Options and progress must already be
/// read.
void begin_at_start(Ui& ui);

/// The name of the button that leads there.
std::string start_button(StartChoice choice);

/// Takes one of the ways, and remembers it for the next time. The walk begins at the first stage.
void take_start_choice(Ui& ui, StartChoice choice);

/// Closes the page when something was opened or set behind it, for example from a menu. To be
/// called once a frame; also notes that a lesson is open, so that the next start continues it.
void follow_start_page(Ui& ui);

} // namespace rasterwalk
