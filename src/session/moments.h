#pragma once

#include <string>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The moment of a frame that a text names, on the command line, in a link or in a lesson. In a row
/// that exists, a column that does not (`t12/r37`, `t12/r37/c9999`) stands for the next moment
/// after it. Throws UsageError that says which moments exist.
Cursor moment_of(const Frame& frame, const std::string& text);
Cursor moment_of(const Frame& frame, const Cursor& cursor);

} // namespace rasterwalk
