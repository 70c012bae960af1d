#pragma once

#include <string>

#include "ui/lesson/lesson_state.h"
#include "ui/lesson/page_footer.h"

namespace rasterwalk {

struct Ui;

/// The current step of the open lesson: text, tasks and predictions.
void draw_step_text(Ui& ui, const Lesson& lesson, float width);

/// A bar for each step, and buttons to its neighbours; after the last step, to the next lesson.
void draw_step_footer(Ui& ui, const Lesson& lesson, float width);

/// The pages that the footer walks through, and going to the page wanted: one beyond the last is
/// the next lesson.
PageFooter pages_of_lesson(Ui& ui, const Lesson& lesson);
void turn_to_step(Ui& ui, const Lesson& lesson, int wanted);

/// Goes forward or back in the lesson as the buttons say; after its last step, to the next lesson.
void turn_in_lesson(Ui& ui, const Lesson& lesson, int direction);

/// The current step. Valid as long as the lesson is.
const LessonStep& shown_step(const Ui& ui, const Lesson& lesson);

/// "step 3 of 7"; for the opening, "lesson 4".
std::string place_in_lesson(const Ui& ui, const Lesson& lesson);

/// What is wrong with the lesson's file, if anything.
void draw_lesson_faults(Ui& ui, const Lesson& lesson);

} // namespace rasterwalk
