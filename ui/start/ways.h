#pragma once

// How the program begins: the three ways of the start page, and which of them is gone.

#include <string>

#include "ui/start/start_state.h"

namespace rasterwalk {

struct Ui;

/// How the program begins when the command line names nothing: the first time with the start page;
/// later where the student stopped, on the way that they took. Options and progress were read.
void begin_at_start(Ui& ui);

/// The name of the button that leads there.
std::string way_button(Way way);

/// Goes one of the ways, and remembers it for the next time. The walk begins at the first stage.
void take_way(Ui& ui, Way way);

/// Closes the page when something was opened or set behind it, as from a menu. To be called once a
/// frame; also notes that a lesson is open, so that the next start goes on with it.
void follow_start_page(Ui& ui);

} // namespace rasterwalk
