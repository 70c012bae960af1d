#pragma once

#include "base/faults.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// The most words of the quote, without "Look back".
inline constexpr int most_look_back_words = 40;

/// Reports where a look back breaks its rules, see lessons/README.md: it is the last part of the
/// opening, short, and leaves the picture as it is, and its `because` ends with a link to a lesson.
void check_looks_back(const Lesson& lesson, FaultList& faults);

} // namespace rasterwalk
