#pragma once

// The TOML blocks of a lesson. Whatever is wrong in one goes to the list of faults, with its line;
// what is right is read all the same.

#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "base/faults.h"
#include "base/toml_block.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// Reads the `lesson` block into the lesson, and what it shows. In all of these, `line` is where
/// the block begins: faults of the whole block are reported there.
ViewState read_lesson_block(const toml::table& table, int line, Lesson& lesson, FaultList& faults);

/// The id of a task, a prediction or a puzzle: lower-case letters, digits, - and _, because it is
/// written to the progress file. Throws InputError.
std::string read_question_id(const TomlBlock& block, const toml::node& node);

LessonTask read_task(const toml::table& table, int line, FaultList& faults);

/// @param step what the step that it is in shows
LessonPrediction read_prediction(const toml::table& table, int line, const ViewState& step,
                                 FaultList& faults);

} // namespace rasterwalk
