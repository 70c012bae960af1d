#pragma once

// Whether a lesson keeps what it promises: what its steps say can be shown, its links lead
// somewhere, its tasks can be solved and are not solved before, its predictions have an answer.

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "session/session.h"

namespace rasterwalk {

/// Everything that is wrong with a lesson, in the order of its lines: what the reader found, and
/// what is found by playing it through.
/// @param session presets and glossary are taken from it
std::vector<Fault> check_lesson(const Lesson& lesson, const Session& session);

/// A session with nothing but presets and glossary, to play lessons in.
Session empty_session();

/// The faults of TeX in a formula: commands that the program does not draw, braces that do not
/// close, arguments that are missing, too deep a nesting.
std::vector<std::string> formula_faults(std::string_view tex);

inline constexpr int deepest_formula = 12; ///< braces and arguments in one another

} // namespace rasterwalk
