#pragma once

// The prose in a file: the text of a page, the strings of a program or a data file, and their
// comments.

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

/// The kind of a file, by its name; none if it holds no prose.
std::optional<ProseKind> prose_kind(std::string_view path);

/// A word of the prose.
struct ProseWord {
    std::string text;     ///< in lower case; code and placeholders are "{}"
    int line = 0;         ///< of the file, from 1
    bool follows = false; ///< only blanks are between it and the previous word
};

/// The words of a file, in order. Comments on consecutive lines are one text, and so are strings
/// with nothing between them.
std::vector<ProseWord> prose_of(std::string_view text, ProseKind kind);

} // namespace rasterwalk
