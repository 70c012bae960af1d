#pragma once

#include <optional>
#include <vector>

#include "ui/actions/row_table_layout.h"
#include "ui/canvas/canvas_state.h"
#include "ui/canvas/compare_view.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

/// The row table of this frame.
struct SideRowTable {
    RowTableLayout layout;
    RowTablePlace place;
};

/// The row table, once the picture is placed: the first of these that covers no pixel of the
/// triangle's rows at the right edge of the canvas, or at the left one. None if they all do, the
/// zoom gives no room for it, or no row of the triangle is in view.
std::optional<SideRowTable>
place_row_table(const Ui& ui, const std::vector<RowTableLayout>& layouts, const Pane& canvas);

/// leftPixels and rightPixels of the triangle shown, each line as high as the row of the picture
/// that it describes, and next to it. A click on a line selects the row; a click on an end that is
/// written leads to its sample. Costs what is visible.
/// @return is the pointer over it?
bool draw_side_row_table(Ui& ui, const SideRowTable& table, const Pane& canvas);

/// The same table, large, in place of an inspector that would show the rows in a lecture; after the
/// canvas, because it is next to the canvas's rows. Returns false, and draws nothing, where the
/// inspector stays.
bool draw_row_table_for_inspector(Ui& ui, const Area& area);

} // namespace rasterwalk
