#pragma once

#include <string>

#include "lessons/lesson.h"

namespace rasterwalk {

struct Ui;

/// Is the current step the lesson's last?
bool is_last_step(const Ui& ui, const Lesson& lesson);

/// The end of a lesson, as Markdown: what was predicted correctly and what was done, where to go
/// next, and the lesson's sources.
std::string end_of_lesson(Ui& ui, const Lesson& lesson);

/// The same below the last step's text.
void draw_lesson_end(Ui& ui, const Lesson& lesson, float width);

} // namespace rasterwalk
