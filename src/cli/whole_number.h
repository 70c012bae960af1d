#pragma once

#include <string>
#include <string_view>

namespace rasterwalk {

/// The number that an option was given. Throws UsageError if the word is no whole number in this
/// range, both ends included.
/// @param option as written: "--rounds"
int whole_number(std::string_view option, const std::string& word, int smallest, int largest);

} // namespace rasterwalk
