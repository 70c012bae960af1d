#pragma once

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// The step on show of the lesson that is open: text, tasks and predictions.
void draw_step_text(Ui& ui, const Lesson& lesson, float width);

/// A bar a step, and the way to its neighbours; from the last step on to the next lesson.
void draw_step_footer(Ui& ui, const Lesson& lesson, float width);

} // namespace rasterwalk
