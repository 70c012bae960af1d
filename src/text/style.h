#pragma once

// Phrases that read as if they were translated, with advice on what to write instead.

#include <string>
#include <string_view>
#include <vector>

#include "base/faults.h"
#include "text/prose.h"

namespace rasterwalk {

/// Words in a row: for each place the allowed words, in lower case; "*" is any word.
using Phrase = std::vector<std::vector<std::string>>;

struct StyleRule {
    Phrase phrase;
    std::string advice; ///< what to write instead
};

struct StyleGuide {
    std::vector<StyleRule> rules;
    std::vector<Phrase> meant; ///< no rule applies within these
};

/// Reads the file of phrases (lessons/style.toml). A phrase is words between blanks, each with
/// alternatives: "one|two more *". Throws InputError, and AccessError for a file that cannot be
/// read.
StyleGuide read_style(const std::string& path);
StyleGuide parse_style(std::string_view text, const std::string& path);

/// Each phrase of a rule in a text, at the line of its first word: the words found, and the advice;
/// at most `most_faults`.
std::vector<Fault> style_faults(const std::vector<ProseWord>& words, const StyleGuide& guide);

} // namespace rasterwalk
