#pragma once

// What g++, clang++ and the linker say, taken apart.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mine/compile/compile.h"

namespace rasterwalk {

/// The most messages that are kept of a program.
inline constexpr std::size_t most_messages = 50;

/// A message, and the places of the program through which the compiler came to it: those that use a
/// template, the last one first.
struct SaidMessage {
    struct Place {
        std::string file;
        int line = 0;
    };
    CompileMessage message;
    std::vector<Place> through;
    std::vector<Place> notes; ///< where the first definition is, or what was called
};

/// The messages in a compiler's or linker's output, which must be in English. A note belongs to its
/// error: it is a further line of its text, unless it is about a header of the system. What only
/// says where an error is, or that there was one, is left out.
std::vector<SaidMessage> read_compile_messages(std::string_view output);

/// The likely cause of a message in a sentence, or empty: there is none that is always true.
std::string likely_cause(std::string_view text);

} // namespace rasterwalk
