#pragma once

#include <optional>
#include <string_view>

namespace rasterwalk {

/// The most dots in one TOML key, and the most nested brackets. toml++ makes, reads and frees
/// tables recursively; with these bounds the depth stays at about a thousand.
inline constexpr int most_key_dots = 32;
inline constexpr int most_nested_brackets = 32;

/// The first line, from 1, in which a TOML text goes beyond these bounds; none if it stays within
/// them. Strings and comments do not count.
std::optional<int> line_nested_too_deeply(std::string_view text);

} // namespace rasterwalk
