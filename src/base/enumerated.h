#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// "a", "a and b", "a, b and c"; empty if there are none.
/// @param last goes before the last: "and", "or"
std::string enumerated(const std::vector<std::string>& names, std::string_view last = "and");

} // namespace rasterwalk
