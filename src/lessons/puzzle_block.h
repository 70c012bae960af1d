#pragma once

#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "base/faults.h"
#include "lessons/lesson_puzzle.h"

namespace rasterwalk {

/// Reads the block `order` of a lesson and the code that follows it. Whatever is wrong goes to the
/// list of faults; the puzzle has no lines if it cannot be asked.
/// @param line where the block begins
/// @param code the lines between the fences
/// @param code_line of the first fence
LessonPuzzle read_puzzle(const toml::table& table, int line,
                         const std::vector<std::string_view>& code, int code_line,
                         FaultList& faults);

} // namespace rasterwalk
