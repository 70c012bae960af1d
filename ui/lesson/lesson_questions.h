#pragma once

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// A task as a box: what is to be done, a hint on request, a tick when it is solved.
void draw_task(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);

/// The same without a box, for a strip; of what the program says only the first lines.
void draw_task_lines(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);
void draw_prediction_lines(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                           float width);

/// A prediction as a box: the question, a way to answer, and afterwards what the program says.
void draw_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction, float width);

} // namespace rasterwalk
