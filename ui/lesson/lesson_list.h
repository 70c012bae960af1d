#pragma once

namespace rasterwalk {

struct Ui;

/// All lessons with their progress; or, during a search, the places found in the lessons and the
/// glossary.
void draw_lesson_list(Ui& ui, float width);

} // namespace rasterwalk
