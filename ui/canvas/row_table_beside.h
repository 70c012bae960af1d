#pragma once

#include <optional>

#include "ui/actions/row_table_layout.h"
#include "ui/canvas/canvas_state.h"
#include "ui/canvas/compare_view.h"

namespace rasterwalk {

/// The edge of the canvas that the row table takes, once the picture is placed: that at which it
/// covers less of the triangle on show. None where the zoom gives no room for it, or no row of the
/// triangle is in view.
std::optional<RowTablePlace> place_row_table(const Ui& ui, const RowTableLayout& layout,
                                             const Pane& canvas);

/// leftPixels and rightPixels of the triangle on show, each line as high as the row of the picture
/// that it describes, and beside it. A click on a line selects the row, one on an end that is
/// written leads to its sample. Costs what is visible.
/// @return is the pointer over it?
bool draw_row_table_beside(Ui& ui, const RowTableLayout& layout, const RowTablePlace& place,
                           const Pane& canvas);

} // namespace rasterwalk
