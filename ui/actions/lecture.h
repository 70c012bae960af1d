#pragma once

namespace rasterwalk {

struct Ui;

/// The lecture mode, for a projector: large text and no distractions. It changes no settings, so
/// leaving it brings everything back.
void toggle_lecture(Ui& ui);

/// Go to the next and to the previous thing: a step of the open lesson or, in a strip, a card of
/// the step; in a lecture without a lesson, a piece of work of the size chosen next to the play
/// button.
void walk_on(Ui& ui);
void walk_back(Ui& ui);

} // namespace rasterwalk
