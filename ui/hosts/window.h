#pragma once

#include <string>

#include "session/session.h"

namespace rasterwalk {

/// Shows the session in a window until it is closed. Sleeps while nothing happens. Throws Error
/// with ExitCode::no_display where no window can be opened.
///
/// If the environment names a file in RASTERWALK_WIDGET_REPORT, screen_report() is written there
/// whenever it changes: a program that looks on from outside then knows where to click.
/// @param is_plain the command line names nothing: the start page, or what the student left
/// @param model    a large model to be read beside the session; empty: none
void show_window(Session session, bool is_plain, const std::string& model = {});

} // namespace rasterwalk
