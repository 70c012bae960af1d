#pragma once

namespace rasterwalk {

struct Ui;

/// In a menu bar or an open popup: all menus with their contents.
/// @param top no menu may reach above this, screen pixels
void draw_menus(Ui& ui, float top);

} // namespace rasterwalk
