#pragma once

// The lines of the row table: a row of the picture, or a sample that fell outside.

#include "inspect/row_history.h"

namespace rasterwalk {

struct Ui;

/// Columns of the table without the values of the ends: all of them, and those of a table whose
/// ends were not written by samples.
inline constexpr int all_row_columns = 6;
inline constexpr int row_columns_without_writers = 4;

/// Does the table being drawn have the numbers of pixels? Without room they give way to what wrote
/// the ends: the pixels can be counted from the ends.
bool has_counts();

/// Do samples write the ends of the rows, so that there is one to name?
bool has_writers(const Ui& ui);

/// The width of a cell that says what wrote an end and how often it was replaced, screen pixels.
float width_of_writer(const Ui& ui);

/// A row of the table of the triangle shown.
/// @param index in the table, from 0
void draw_row_line(Ui& ui, int index);

/// A sample that fell outside the table: a red line, with the float value that is to blame.
/// @param number among all such samples, from 0
void draw_outside_line(Ui& ui, const OutsideSample& sample, int number);

} // namespace rasterwalk
