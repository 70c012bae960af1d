#pragma once

// What a person reads in a file: the text of a page, the strings of a program or a data file, and
// their comments.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

enum class ProseKind {
    markdown, ///< text outside code; of comments, as in lessons, the strings in quotes
    program,  ///< C++ and JavaScript: comments and strings in double quotes
    data,     ///< TOML: comments and strings
    script    ///< shell, Python and CMake: comments
};

/// By the name of the file; none if it holds no prose.
std::optional<ProseKind> prose_kind(std::string_view path);

/// A word as it is read.
struct ProseWord {
    std::string text;     ///< in small letters; code and placeholders are "{}"
    int line = 0;         ///< of the file, from 1
    bool follows = false; ///< there is nothing but blanks between it and the word before
};

/// The words of a file, in order. Comments on consecutive lines, and strings with nothing between
/// them, are one text.
std::vector<ProseWord> prose_of(std::string_view text, ProseKind kind);

} // namespace rasterwalk
