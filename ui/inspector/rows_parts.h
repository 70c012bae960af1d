#pragma once

#include <functional>

namespace rasterwalk {

struct Ui;

// The parts of the row table's panel; see rows_panel.cpp.

/// The row table of the triangle on show, as far as it is made at the cursor.
/// @param height screen pixels
void draw_row_table(Ui& ui, float height);

/// The same where there are few lines, in all that is left of the panel: the headers stay, the rows
/// scroll together with what is drawn below them.
void draw_row_table_with(Ui& ui, const std::function<void()>& below);

} // namespace rasterwalk
