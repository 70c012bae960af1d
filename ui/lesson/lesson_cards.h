#pragma once

#include "lessons/lesson.h"
#include "ui/lesson/lesson_state.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

struct Ui;

/// Cuts the current step into its cards, unless they are already cut for this room.
/// @param width of a line, screen pixels
/// @param height the most that a card can have, screen pixels
void cut_cards(Ui& ui, const Lesson& lesson, const LessonStep& step, float width, float height);

/// Draws the parts of a step as words that can be pressed: text, question, task. The one shown is
/// underlined. As many as fit; none if the step is one card.
/// @param shown index of the part shown, -1: none
/// @return the part that was pressed, or -1
int draw_part_words(Ui& ui, const Lesson& lesson, const LessonStep& step, int shown,
                    const Area& area);
float part_words_width(Ui& ui, const Lesson& lesson, const LessonStep& step, int shown);

/// The first card of a part, or of the next part if it has none.
int card_of_part(const LessonStrip& strip, int part);

} // namespace rasterwalk
