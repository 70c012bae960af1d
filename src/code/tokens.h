#pragma once

// The tokens of the small part of C++ that a program of the lab is written in.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

struct CodeToken {
    enum class Kind : std::uint8_t {
        name,
        integer,     ///< 12
        real,        ///< 1.5 or 1e3: a double
        single_real, ///< 1.5f
        text,        ///< "with its quotes"
        sign,        ///< the longest of C++'s: `+=`, `::`, `(`
        end,         ///< comes last
    };
    Kind kind = Kind::end;
    std::string_view text; ///< in the source
    int line = 1;          ///< from 1
};

/// A note to the program that shows the code, which students do not see: what follows `//@` in a
/// line.
struct CodeMark {
    int line = 1; ///< from 1
    std::string_view text;
};

/// A source cut into tokens. Both refer to the text.
struct CodeTokens {
    std::vector<CodeToken> tokens; ///< the last one is `end`
    std::vector<CodeMark> marks;
};

/// Cuts a source into tokens, without comments and without lines that begin with `#`. Throws
/// InputError, with the file and the line, for a sign that C++ does not have, and for a comment or
/// a text that does not end.
/// @param file its name, for messages
CodeTokens tokens_of(std::string_view source, const std::string& file);

} // namespace rasterwalk
