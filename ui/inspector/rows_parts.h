#pragma once

#include <functional>
#include <optional>

#include "stages/edge_functions.h"

namespace rasterwalk {

struct Ui;

// The parts of the row table's panel; see rows_panel.cpp.

/// The row table of the triangle shown, as far as it is built at the cursor.
/// @param height screen pixels
void draw_row_table(Ui& ui, float height);

/// The same as part of a page that scrolls: the whole table, whose rows are lines of that page. It
/// scrolls to no row, so what is above it stays in sight.
void draw_row_table_in_page(Ui& ui);

/// The same where there are few lines, in the rest of the panel: the headers stay, the rows scroll
/// together with what is drawn below them.
void draw_row_table_with(Ui& ui, const std::function<void()>& below);

/// The tested pixel of the triangle shown that is explained: the moment's, or else the picked one
/// if it has been tested by then.
std::optional<PixelTest> shown_test(const Ui& ui);

/// That pixel: each edge with the value of its function and what it requires, the weights of the
/// corners, and how the number that was clicked was computed.
void draw_pixel_test(Ui& ui, const PixelTest& test);

/// Is there anything to show in small pictures? Only if coverage tests the centres of pixels: an
/// edge that the triangle shares with a neighbour, or a polygon of the scene that it belongs to.
bool has_coverage_pictures(Ui& ui);

/// That edge under each fill rule, or that polygon with each way to cover it. A click on a rule
/// draws with it. Only if there are any.
void draw_coverage_pictures(Ui& ui);

/// Scrolls to the row just drawn. A table that has just appeared knows its height a frame later:
/// the request stays until the row is seen.
/// @param line of the row, from the first that can be scrolled away
/// @param height of a line, screen pixels
/// @param is_last there are no rows below it
void bring_into_view(Ui& ui, int line, float height, bool is_last);

/// The row to bring into view, as an index into the table, -1: none. A table that has just appeared
/// or changed its height shows its selected row, or else the row at work.
/// @param height of what scrolls, screen pixels
int wanted_row(Ui& ui, float height);

} // namespace rasterwalk
