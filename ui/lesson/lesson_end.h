#pragma once

#include <string>

#include "lessons/lesson.h"

namespace rasterwalk {

struct Ui;

/// Is the current step the lesson's last?
bool is_last_step(const Ui& ui, const Lesson& lesson);

/// What stands at the end of a lesson, as Markdown: what was predicted right and what was done,
/// where to go next, and on what the lesson rests.
std::string end_of_lesson(Ui& ui, const Lesson& lesson);

/// The same below the last step's text.
void draw_lesson_end(Ui& ui, const Lesson& lesson, float width);

} // namespace rasterwalk
