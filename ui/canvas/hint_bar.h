#pragma once

// What can be said about the picture of a model, with the setting that shows more of it.

namespace rasterwalk {

struct Ui;

/// A line above the picture with the first of the hints, a button that sets what it names, and one
/// that hides it; nothing where there is none, or where a question asks for the settings.
void draw_hint_bar(Ui& ui);

} // namespace rasterwalk
