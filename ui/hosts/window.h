#pragma once

#include <memory>
#include <string>

#include "session/file_reading.h"
#include "session/session.h"

namespace rasterwalk {

/// Shows the session in a window until it is closed. Sleeps while nothing happens. Throws Error
/// with ExitCode::no_display if no window can be opened.
///
/// If the environment names a file in RASTERWALK_WIDGET_REPORT, screen_report() is written there
/// whenever it changes: a program that watches from outside then knows where to click.
/// @param is_plain the command line names nothing: the start page, or what the student left
/// @param reading  what to show once it is read; null: nothing
/// @param code     the student's own program, to be checked; empty: none
void show_window(Session session, bool is_plain, std::unique_ptr<FileReading> reading,
                 const std::string& code);

} // namespace rasterwalk
