#pragma once

// What is inside the lines of a lesson's text: links, pictures, formulas, footnotes. Code is
// skipped.

#include <string_view>
#include <vector>

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// What was found, each in reading order.
struct InlineParts {
    std::vector<LinkPlace> links;     ///< and pictures
    std::vector<TextPlace> formulas;  ///< without the dollar signs
    std::vector<TextPlace> footnotes; ///< labels of [^label]
};

/// Finds them with the parse that is drawn for the student. What the format of lessons does not
/// have (reference links, bare addresses, comments within a line, too deep nesting) is a fault.
/// @param first_line line of the file where the text begins
InlineParts find_inline_parts(std::string_view text, int first_line, FaultList& faults);

} // namespace rasterwalk
