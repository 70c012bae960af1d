#pragma once

// Taking a text apart: its lines, its parts between separators, its ends.

#include <string_view>
#include <vector>

namespace rasterwalk {

/// The text without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// The parts of the text between separators, the empty ones too.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Takes the first part off a text, up to the separator or the end, and the separator with it.
std::string_view take_part(std::string_view& text, char separator);

/// The lines of a text without their ends, which may be those of Windows.
std::vector<std::string_view> split_lines(std::string_view text);

} // namespace rasterwalk
