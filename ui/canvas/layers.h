#pragma once

namespace rasterwalk {

struct Ui;

/// The button in the canvas header that opens the list of everything that can be drawn over the
/// picture or in and next to its cells.
/// @param narrow a sign in place of the word, for small windows
void draw_layers_button(Ui& ui, bool narrow);
float layers_button_width(const Ui& ui, bool narrow);

} // namespace rasterwalk
