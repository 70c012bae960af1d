#pragma once

// What both row tables, in the Rows tab and next to the picture, say about the ends of a row.

#include <optional>
#include <string>

#include "inspect/row_history.h"

namespace rasterwalk {

struct Ui;

/// "e1 [4]": edge 1, line[4].
std::string sample_text(int edge, int sample);

/// An end as the table shows it: its column, or "+INT_MAX" and "−INT_MAX" if no sample has reached
/// it, "+MAX" and "−MAX" for short.
std::string end_text(const RowEnd& end, bool is_left, bool is_short = false);

/// What wrote an end, how often it was replaced, and what a click does.
std::string writer_tooltip(const EndWriter& writer);

/// "↻: this end has been replaced 2 times so far."
std::string replaced_tooltip(const EndWriter& writer);

/// The same for any kind of end: if it has not been written, or was found without samples, the
/// tooltip says so.
std::string end_tooltip(const Ui& ui, const RowEnd& end, const EndWriter& writer);

/// Goes to the moment just after a sample of the triangle shown was entered, so that its cell is
/// the one that lights up.
void go_to_sample(Ui& ui, int edge, int sample);

/// The row of the picture that the work on the triangle shown has reached: the row of the fragment,
/// sample or tested pixel just done; none if the moment belongs to another triangle.
std::optional<int> row_at_work(const Ui& ui);

/// Which ends of this row of the picture the moment has just written.
RowWrite just_written(const Ui& ui, int row);

} // namespace rasterwalk
