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
    int file = 0;            ///< in the order in which files are read
    int line = 0;            ///< of the file, from 1
    bool is_mistake = false; ///< without a mistake it would not be there
    /// The right lines in its place; of a line that is no mistake, those missing behind it.
    std::vector<std::string> usual{};
};

/// The words of a line as a student reads it: without the marks, which are for the walk.
std::string_view shown_words(std::string_view line);

/// What a word of a condition says: "stage_fill": is it so?
using CodeWord = std::function<bool(std::string_view word)>;

/// Appends the lines of a file for which the words before them hold. Understands #if, #elif, #else
/// and #endif, with words, !, &&, || and parentheses. Throws InputError with file:line for anything
/// else.
/// @param name of the file, for messages
void choose_lines(std::string_view text, const std::string& name, int file, const CodeWord& holds,
                  std::vector<ChosenLine>& lines);

/// Marks the lines of a file that are there only because of a mistake, and gives them the right
/// ones.
/// @param right lines of the same file without the mistakes
void mark_mistakes(std::vector<ChosenLine>& lines, const std::vector<ChosenLine>& right);

} // namespace rasterwalk
