#pragma once

// What there is to say about the picture of a model, with the setting that shows more of it.

namespace rasterwalk {

struct Ui;

/// A line above the picture with the first of the hints, a button that sets what it names, and one
/// that hides it; nothing where there is none, or where the settings are what is asked for.
void draw_hint_bar(Ui& ui);

} // namespace rasterwalk
