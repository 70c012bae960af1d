#pragma once

// Whether a lesson keeps what it promises: what its steps say can be shown, its links lead
// somewhere, its tasks can be solved and are not solved before, its predictions have an answer.

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

} // namespace rasterwalk
