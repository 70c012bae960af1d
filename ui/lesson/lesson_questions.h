#pragma once

#include <string>

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// A task as a box: what is to be done, a hint on request, a tick when it is solved.
void draw_task(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);

/// The same without a box, for a strip.
/// @param because the part of the reason that has room, see LessonCard; the rest is on other cards
void draw_task_lines(Ui& ui, const Lesson& lesson, const LessonTask& task, float width);
void draw_prediction_lines(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                           const std::string& because, float width);

/// What is said after the answer, which must have been judged: Markdown.
std::string reason_on_show(const PredictionView& view);

/// A prediction as a box: the question, a way to answer, and afterwards what the program says.
void draw_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction, float width);

} // namespace rasterwalk
