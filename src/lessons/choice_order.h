#pragma once

#include <string_view>
#include <vector>

namespace rasterwalk {

/// The numbers from 0 to count - 1 in an order that looks random and is the same for everyone, so
/// that the place of a choice gives nothing away.
/// @param name of what is shuffled; a different name gives a different order
std::vector<int> shuffled(int count, std::string_view name);

} // namespace rasterwalk
