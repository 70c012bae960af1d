#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// The page about the stage on show, from lessons/stages, and below it the way to its neighbours.
std::string stage_page_name(Ui& ui); ///< by which its scroll position is known
void draw_stage_text(Ui& ui, float width);
void draw_stage_footer(Ui& ui, float width);

} // namespace rasterwalk
