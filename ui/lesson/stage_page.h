#pragma once

#include <string>

#include "lessons/stage_note.h"
#include "ui/lesson/page_footer.h"

namespace rasterwalk {

struct Ui;

/// The page about the current stage, from lessons/stages, and below it buttons to its neighbours.
std::string stage_page_name(Ui& ui); ///< identifies its scroll position
void draw_stage_text(Ui& ui, float width);
void draw_stage_footer(Ui& ui, float width);

/// The text of a stage's note, with the numbers of the current frame.
std::string shown_note(const Ui& ui, const StageNote& note);

/// The stages that the footer walks through, and going to the stage wanted.
PageFooter pages_of_stages(const Ui& ui);
void turn_to_stage(Ui& ui, int wanted);

} // namespace rasterwalk
