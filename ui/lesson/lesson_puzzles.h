#pragma once

#include "ui/lesson/lesson_state.h"

namespace rasterwalk {

struct Ui;

/// A puzzle as a box: its text, the function, the lines that are left, and what came of running it.
void draw_puzzle(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, float width);

/// The same without a box, for a strip.
void draw_puzzle_lines(Ui& ui, const Lesson& lesson, const LessonPuzzle& puzzle, float width);

} // namespace rasterwalk
