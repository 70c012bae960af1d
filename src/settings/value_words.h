#pragma once

#include <string>
#include <string_view>

#include "settings/setting_table.h"

namespace rasterwalk {

/// A word of a choice as a student would say it: "cut toward 0" for `truncate`. A word that is
/// clear enough stays, with blanks for its underscores.
std::string choice_words(const Setting& setting, std::string_view word);

/// A setting's value in words: its word, or its numbers. "mixed" if its parts have no word in
/// common.
std::string value_words(const Setting& setting, const Settings& settings);

} // namespace rasterwalk
