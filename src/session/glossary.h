#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/language.h"

namespace rasterwalk {

/// A word of the lab.
struct Term {
    std::string word;
    std::string sentence;     ///< what it means, one sentence
    std::string section;      ///< of the lab
    bool is_everyday = false; ///< everyday English has it too, so that using it proves nothing
};

/// Reads a glossary (lessons/glossary.toml): terms in alphabetical order, each once. Throws
/// AccessError, or InputError with file:line.
std::vector<Term> read_glossary(const std::string& path);
std::vector<Term> parse_glossary(std::string_view text, const std::string& path);

/// The section of a term, a lesson or a stage in words: "lab: Drawing edges"; one beyond the lab
/// unchanged, "Beyond the lab: textures".
std::string section_words(std::string_view section, const Language& language = english());

} // namespace rasterwalk
