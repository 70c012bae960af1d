#pragma once

namespace rasterwalk {

struct Ui;

/// All lessons with what is done of them; or, while something is searched for, where it stands in
/// the lessons and the glossary.
void draw_lesson_list(Ui& ui, float width);

} // namespace rasterwalk
