#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "session/session.h"

namespace rasterwalk {

/// The words of a command line that opens the program with exactly this view, `rasterwalk` first.
/// Only what differs is said: from the lesson's step if a lesson is open, or else from the scene.
/// Throws UsageError where it cannot be said: in a quiz, or on a scene that is in no file.
std::vector<std::string> command_line_words(const Session& session);

/// The same as one line for a shell.
std::string command_line_text(const Session& session);

/// A word as a shell reads it: in single quotes unless it is plain.
std::string shell_quoted(std::string_view word);

} // namespace rasterwalk
