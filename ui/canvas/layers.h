#pragma once

namespace rasterwalk {

struct Ui;

/// The button in the canvas header that opens the list of all that can be laid over the picture or
/// stand in and beside its cells.
/// @param narrow a sign in place of the word, for small windows
void draw_layers_button(Ui& ui, bool narrow);
float layers_button_width(const Ui& ui, bool narrow);

} // namespace rasterwalk
