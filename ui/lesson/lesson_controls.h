#pragma once

#include <vector>

#include "lessons/lesson.h"

namespace rasterwalk {

struct Ui;

/// A control of a step with its name before it and its read-out behind it, or below it where the
/// line is too short: the field of the settings sheet, over what the lesson offers of it.
/// @param width of a line, screen pixels
void draw_lesson_control(Ui& ui, const LessonControl& control, float width);

/// The controls that stand next to a part of the step, before it or after it: in a strip, which
/// shows a part at a time, they belong to its card.
std::vector<const LessonControl*> controls_beside(const Lesson& lesson, const LessonStep& step,
                                                  int part);

} // namespace rasterwalk
