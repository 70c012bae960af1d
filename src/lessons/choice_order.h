#pragma once

#include <string_view>
#include <vector>

namespace rasterwalk {

/// The numbers from 0 to count - 1 in an order that looks like chance and is the same for everyone,
/// so that nobody learns where right answers stand.
/// @param name of what is shuffled; another name gives another order
std::vector<int> shuffled(int count, std::string_view name);

} // namespace rasterwalk
