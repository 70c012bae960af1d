#pragma once

#include <string_view>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// Adds what is inside the lines of a text to its step: links, pictures, formulas, footnotes, each
/// in reading order. They are found with the parse that is drawn for the student, so code is
/// skipped. What the format of lessons does not have (reference links, bare addresses, comments
/// within a line, too deep nesting) is a fault.
/// @param first_line line of the file where the text begins
void add_inline_parts(std::string_view text, int first_line, LessonStep& step, FaultList& faults);

} // namespace rasterwalk
