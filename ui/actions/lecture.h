#pragma once

namespace rasterwalk {

struct Ui;

/// The lecture mode, for a projector: the text is large, and what distracts is gone. It changes
/// nothing of what is set, so that leaving it brings everything back.
void toggle_lecture(Ui& ui);

/// Go to the next and to the previous thing: a step of the lesson that is open, or where it is a
/// strip a card of the step; in a lecture without a lesson, a piece of work of the size chosen
/// beside the play button.
void walk_on(Ui& ui);
void walk_back(Ui& ui);

} // namespace rasterwalk
