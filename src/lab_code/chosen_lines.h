#pragma once

// The lab's code is written once for all settings: lines that only some of them need are between
// #if and #endif. What a student reads is what those leave, as from a compiler's preprocessor. A
// line that a mistake has put there knows the right one.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A line of the code for some settings.
struct ChosenLine {
    std::string text;
    int file = 0; ///< in the order in which files are read
    int line = 0; ///< of the file, from 1
    /// Of a line that a mistake has put there, the right one: what follows #else. Otherwise empty.
    std::string usual;
};

/// What the words of conditions mean.
struct CodeWords {
    std::function<bool(std::string_view word)> holds; ///< "stage_fill": is it so?
    std::function<bool(std::string_view word)> is_mistake;
};

/// Appends the lines of a file for which the words before them hold. Understands #if, #elif, #else
/// and #endif, with words, !, &&, || and parentheses. Throws InputError with file:line for anything
/// else.
/// @param name of the file, for messages
void choose_lines(std::string_view text, const std::string& name, int file, const CodeWords& words,
                  std::vector<ChosenLine>& lines);

} // namespace rasterwalk
