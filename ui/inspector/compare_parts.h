#pragma once

#include <string>

#include "session/second_run.h"

namespace rasterwalk {

struct Ui;

// The parts of the Compare tab; see compare_panel.cpp.

/// What the button of a pair does, in words.
std::string tooltip_of_pair(const Session& session, const ComparePair& pair, bool is_shown);

/// The pairs as small pictures of what each would do to the picture, each with its name and what is
/// different; only the names if the scene is too large to be drawn immediately.
void draw_offers(Ui& ui);

/// The same as a line of buttons.
void draw_pairs(Ui& ui);

/// With a student's program as run B: what is compared, and what differs in run A from the rules
/// that its picture was found to have.
void draw_program_run(Ui& ui);

/// Where the program puts the first pixel that we do not; its name leads there.
void draw_program_parting(Ui& ui);

/// Where only the pictures are compared: why, how many pixels differ for which reason, and the
/// first of them.
void draw_reasons(Ui& ui);

} // namespace rasterwalk
