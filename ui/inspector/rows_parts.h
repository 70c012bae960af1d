#pragma once

namespace rasterwalk {

struct Ui;

// The parts of the row table's panel; see rows_panel.cpp.

/// The row table of the triangle on show, as far as it is made at the cursor.
/// @param height screen pixels
void draw_row_table(Ui& ui, float height);

} // namespace rasterwalk
