#pragma once

#include <chrono>
#include <iosfwd>
#include <memory>
#include <string>

#include "inspect/measures.h"
#include "session/file_reading.h"
#include "session/session.h"

namespace rasterwalk {

/// What the command line leaves to its caller.
struct CliRequest {
    bool open_window = false; ///< there was no command: show the session in a window
    bool is_plain = false;    ///< no arguments: the window may choose a lesson
    Session session;          ///< open if `open_window`
    /// How long the window may wait for the files it should show. If they take longer, it reads on
    /// while it shows the usual scene.
    std::chrono::milliseconds patience{500};
    std::unique_ptr<FileReading> reading; ///< null: everything is read
    std::string code; ///< the student's own program, to be checked in the window; empty: none
};

/// Carries out the command line of `rasterwalk`: writes the results to `data`, and messages about
/// them to `messages`. Never throws for a user's mistakes. Returns the exit code (see ExitCode).
/// @param clock for the commands that measure times; without one they are wrong use
/// @param terminal for long commands to show their progress; null: they show none
int run_cli(int argc, const char* const* argv, std::ostream& data, std::ostream& messages,
            CliRequest& request, const Clock& clock = {}, std::ostream* terminal = nullptr);

} // namespace rasterwalk
