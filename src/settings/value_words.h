#pragma once

#include <string>
#include <string_view>

#include "settings/setting_table.h"

namespace rasterwalk {

/// A word of a choice as a student would say it: "cut toward 0" for `truncate`. What says enough
/// by itself stays as it is, with blanks for its underscores.
std::string said_word(const Setting& setting, std::string_view word);

/// A setting's value as it would be said: its word, or its numbers. "mixed" where its parts have no
/// word in common.
std::string said_value(const Setting& setting, const Settings& settings);

} // namespace rasterwalk
