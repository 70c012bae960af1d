#pragma once

#include "cli/json.h"
#include "inspect/row_history.h"

namespace rasterwalk {

/// The rows of a table with the samples that wrote their ends: a list of {row, left, right,
/// left_by, right_by}.
Json rows_json(const RowHistory& history);

/// The samples that fell in no row: a list of {edge, sample, x, y, column, row}.
Json outside_json(const RowHistory& history);

} // namespace rasterwalk
