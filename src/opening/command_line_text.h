#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "session/session.h"

namespace rasterwalk {

/// The words of a command line that opens the program with exactly this view, `rasterwalk` first.
/// Only differences are given: from the lesson's step if a lesson is open, or else from the scene.
/// Throws UsageError if that is impossible: in a quiz, or for a scene that is not in a file.
std::vector<std::string> command_line_words(const Session& session);

/// The same as one line for a shell.
std::string command_line_text(const Session& session);

/// A word for a shell: in single quotes unless it is plain.
std::string shell_quoted(std::string_view word);

} // namespace rasterwalk
