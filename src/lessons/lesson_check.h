#pragma once

// Checks that a lesson keeps its promises: its steps can be shown, its links lead somewhere, its
// tasks can be solved and are not solved at the start, its predictions have an answer.

#include <functional>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"
#include "session/session.h"

namespace rasterwalk {

/// Called before each part of a lesson is checked: "question 3 of 100". May be empty.
using CheckWatch = std::function<void(const std::string& part)>;

/// Everything that is wrong with a lesson, in the order of its lines: what the reader found, and
/// what playing it through finds.
/// @param session presets and glossary are taken from it
std::vector<Fault> check_lesson(const Lesson& lesson, const Session& session);
/// @param trial to play it in
std::vector<Fault> check_lesson(const Lesson& lesson, const Session& session, LessonTrial& trial,
                                const CheckWatch& watch = {});

/// A session with only presets and glossary, to play lessons in.
Session empty_session();

} // namespace rasterwalk
