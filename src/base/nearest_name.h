#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rasterwalk {

/// The name that differs from `wanted` by the fewest letters added, left out or changed; empty if
/// none comes close.
std::string_view nearest_name(std::string_view wanted, std::span<const std::string_view> names);

/// " Did you mean 'light.power'?", or nothing if no name comes close.
std::string did_you_mean(std::string_view wanted, std::span<const std::string_view> names);

/// "there is no tab 'row'; choose from rows, graph. Did you mean 'rows'?"
std::string no_such_name(std::string_view what, std::string_view wanted,
                         std::span<const std::string_view> names);

} // namespace rasterwalk
