#pragma once

// Programs as students hand them in: the styles of tests/mine/styles, and those that
// tests/mine/mistakes.toml makes from them.

#include <string>
#include <vector>

namespace rasterwalk::test {

/// One source file of a student.
struct HandInSource {
    std::string name; ///< without a folder: "main.cpp"
    std::string text;
};

/// A whole program.
struct HandIn {
    std::string name;
    std::string style;  ///< what it was made from
    std::string bug;    ///< id of the mistake: "B9"; empty if the laboratory does not have it
    bool right = false; ///< if nothing is wrong with it
    std::string note;   ///< what the mistake is and where it shows
    std::vector<HandInSource> sources; ///< sorted by name
};

/// The styles themselves, sorted by name; all are right.
std::vector<HandIn> student_styles();

/// The programs of mistakes.toml, in its order. Throws InputError if a style does not exist or if
/// the text to be found is not in it exactly once.
std::vector<HandIn> student_mistakes();

/// Reads a file or a folder of tests/mine, "styles/classic.cpp" or "handout/03-edges".
std::vector<HandInSource> student_sources(const std::string& path);

} // namespace rasterwalk::test
