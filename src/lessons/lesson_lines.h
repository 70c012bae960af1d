#pragma once

// The lines of a lesson's file, and checks before they are read.

#include <string_view>
#include <vector>

#include "base/faults.h"

namespace rasterwalk {

/// The lines of a text without their ends, which may be those of Windows.
std::vector<std::string_view> split_lines(std::string_view text);

/// Are the lines few and short enough, and all of them UTF-8 without control characters? If not,
/// the file is refused.
bool check_lines(const std::vector<std::string_view>& lines, FaultList& faults);

} // namespace rasterwalk
