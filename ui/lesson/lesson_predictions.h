#pragma once

#include <string>

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// What is said after the answer, which must already be judged: Markdown.
std::string shown_reason(const PredictionView& view);

/// A prediction as a box: the question, a way to answer, and afterward what the program says.
void draw_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction, float width);

/// The same without a box, for a strip.
/// @param because the part of the reason that fits, see LessonCard; the rest is on other cards
void draw_prediction_lines(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                           const MarkdownDocument& because, float width);

} // namespace rasterwalk
