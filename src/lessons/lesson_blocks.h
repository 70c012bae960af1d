#pragma once

// The TOML blocks of a lesson. Whatever is wrong in one goes to the list of faults, with its line;
// what is right is read all the same.

#include <string_view>

#include <toml++/toml.h>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// What the block `lesson` says: into the lesson, and its situation.
/// In all of these `line` is where the block begins: faults of the whole block are told there.
Situation read_lesson_block(const toml::table& table, int line, Lesson& lesson, FaultList& faults);

/// What a block `step`, or a table `at` or `then`, says.
/// @param what how messages name the table
Situation read_situation(const toml::table& table, int line, FaultList& faults,
                         const char* what = "the block");

LessonTask read_task(const toml::table& table, int line, FaultList& faults);

/// @param step the situation of the step in which it stands
LessonPrediction read_prediction(const toml::table& table, int line, const Situation& step,
                                 FaultList& faults);

} // namespace rasterwalk
