#pragma once

// Checks of the lines of a lesson's file before they are read.

#include <string_view>
#include <vector>

#include "base/faults.h"

namespace rasterwalk {

/// Are the lines few and short enough, and all of them UTF-8 without control characters? If not,
/// the file is refused.
bool check_lines(const std::vector<std::string_view>& lines, FaultList& faults);

} // namespace rasterwalk
