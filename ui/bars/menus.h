#pragma once

namespace rasterwalk {

struct Ui;

/// In a menu bar or an open popup: all menus with their contents.
void draw_menus(Ui& ui);

} // namespace rasterwalk
