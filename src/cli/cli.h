#pragma once

#include <chrono>
#include <iosfwd>
#include <memory>

#include "inspect/culling_cost.h"
#include "session/file_reading.h"
#include "session/session.h"

namespace rasterwalk {

/// What the command line leaves to its caller.
struct CliRequest {
    bool open_window = false; ///< there was no command: show the session in a window
    bool is_plain = false;    ///< nothing was asked for: the window may choose a lesson
    Session session;          ///< open if `open_window`
    /// How long the window may be kept waiting for what it is to show. What takes longer it reads
    /// on while it shows the usual scene.
    std::chrono::milliseconds patience{500};
    std::unique_ptr<FileReading> reading; ///< null: all is read
};

/// Carries out the command line of `rasterwalk`: writes what was asked for to `data`, and what is
/// said about it to `messages`. Never throws for what a user may do wrong. Returns the exit code
/// (see ExitCode).
/// @param clock for the commands that measure times; without one they are wrong usage
/// @param terminal for long commands to say how far they are; null: they say nothing
int run_cli(int argc, const char* const* argv, std::ostream& data, std::ostream& messages,
            CliRequest& request, const Clock& clock = {}, std::ostream* terminal = nullptr);

} // namespace rasterwalk
