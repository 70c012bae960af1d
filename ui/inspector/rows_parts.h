#pragma once

#include <functional>
#include <optional>

#include "stages/edge_functions.h"

namespace rasterwalk {

struct Ui;

// The parts of the row table's panel; see rows_panel.cpp.

/// The row table of the triangle shown, as far as it is made at the cursor.
/// @param height screen pixels
void draw_row_table(Ui& ui, float height);

/// The same as a part of a page that scrolls: the whole table, whose rows are lines of that page.
/// It scrolls to no row, so what stands above it stays in sight.
void draw_row_table_in_page(Ui& ui);

/// The same where there are few lines, in all that is left of the panel: the headers stay, the rows
/// scroll together with what is drawn below them.
void draw_row_table_with(Ui& ui, const std::function<void()>& below);

/// The tested pixel of the triangle shown that is explained: the one of the moment, or else the
/// picked one if it has been tested by then.
std::optional<PixelTest> shown_test(const Ui& ui);

/// That pixel: each edge with the value of its function and what it asks for, the weights of the
/// corners, and how the number that was clicked came to be.
void draw_pixel_test(Ui& ui, const PixelTest& test);

/// Is there anything to show in small pictures? Only where coverage asks the centres of pixels: an
/// edge that the triangle shares with a neighbour, or a polygon of the scene that it belongs to.
bool has_coverage_pictures(Ui& ui);

/// That edge by each fill rule, or that polygon by each way to cover it. A click on a rule draws
/// with it. Only if there are any.
void draw_coverage_pictures(Ui& ui);

/// Scrolls to the row just drawn. A table that has only just come knows its height a frame later:
/// what is wanted stays wanted until it is seen.
/// @param line of the row, from the first that can be scrolled away
/// @param height of a line, screen pixels
/// @param is_last below it there are no rows
void bring_into_view(Ui& ui, int line, float height, bool is_last);

/// The row to bring into view, as an index into the table, -1: none. A table that comes to be shown
/// or gets another height shows its selected row, or else the row at work.
/// @param height of what scrolls, screen pixels
int wanted_row(Ui& ui, float height);

} // namespace rasterwalk
