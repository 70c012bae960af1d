#pragma once

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// A task as a box: what is to be done, a hint on request, what a try misses, and when it is solved
/// a tick and the reason.
void draw_task(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);

/// The same without a box, for a strip.
void draw_task_lines(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);

} // namespace rasterwalk
