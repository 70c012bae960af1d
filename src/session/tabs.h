#pragma once

#include <span>
#include <string_view>

namespace rasterwalk {

/// The tabs of the inspector, by the names that lessons, files and options use.
std::span<const std::string_view> tab_names();

} // namespace rasterwalk
