#pragma once

#include <vector>

#include "lessons/lesson.h"

namespace rasterwalk {

struct Ui;

/// A control of a step with its name before it and its read-out after it, or below it if the line
/// is too short: the field of the settings sheet, limited to the range that the lesson offers.
/// @param width of a line, screen pixels
void draw_lesson_control(Ui& ui, const LessonControl& control, float width);

/// The controls next to a part of the step, before it or after it: in a strip, which shows a part
/// at a time, they are on its card.
std::vector<const LessonControl*> controls_of_part(const Lesson& lesson, const LessonStep& step,
                                                   int part);

} // namespace rasterwalk
