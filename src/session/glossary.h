#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A word of the lab.
struct Term {
    std::string word;
    std::string sentence; ///< what it means, one sentence
    std::string section;  ///< of the lab
};

/// Reads a glossary (lessons/glossary.toml): terms in alphabetical order, each once. Throws
/// AccessError, or InputError with file:line.
std::vector<Term> read_glossary(const std::string& path);
std::vector<Term> parse_glossary(std::string_view text, const std::string& path);

} // namespace rasterwalk
