#pragma once

// The way through the window by keys alone: Tab goes from widget to widget, F6 from part to part,
// Enter and Space press, the arrows move what can be moved.

namespace rasterwalk {

struct Ui;
struct Chord;

/// Takes the keys meant for the widget with the keyboard and those that lead to another one. To be
/// called once a frame, before anything is drawn.
void take_focus_keys(Ui& ui);

/// Is an arrow held that the focused widget takes? While it is, everything counts as one change.
bool is_moving_by_arrows(const Ui& ui);

/// Is the key the focused widget's own, so that it does nothing else?
bool belongs_to_focus(const Ui& ui, const Chord& chord);

} // namespace rasterwalk
