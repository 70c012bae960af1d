#pragma once

// Capitals and small letters of ASCII; every other byte stays unchanged.

#include <string>
#include <string_view>

namespace rasterwalk {

/// The text with small letters in place of its capitals.
std::string in_small_letters(std::string_view text);

/// Is one text found in the other, whatever its capitals?
bool contains_in_any_case(std::string_view text, std::string_view part);

} // namespace rasterwalk
