#pragma once

// Code that a student puts in order. Whether it is right is found by running it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A line of a function without the braces, which follow from the depths.
struct PuzzleLine {
    std::string text;
    int depth = 0; ///< how many braces it is in; 0: the line that names the function

    friend bool operator==(const PuzzleLine&, const PuzzleLine&) = default;
};

/// A function whose lines are offered out of order, with some that do not belong in it.
struct LessonPuzzle {
    std::string id;
    std::string exam;              ///< the questions that the function is asked, see find_exam()
    std::vector<PuzzleLine> lines; ///< of a right function
    int given = 1;                 ///< lines at the beginning that are in place already
    int given_after = 0;           ///< and at the end
    std::vector<std::string> distractors; ///< lines that do not belong in it
    std::vector<int> order;               ///< the pieces as they are offered, see piece_text()
    std::string because;                  ///< why it is right: Markdown; may be empty
    std::string text; ///< Markdown that the student reads, without the quote's `>`
    int step = 0;
    int line = 0;      ///< of its comment
    int code_line = 0; ///< of the fence
};

/// Is one line missing, which one of the pieces fills?
bool is_gap(const LessonPuzzle& puzzle);

/// A piece is a line that is not given, by its place after those before it, or a distractor, after
/// all such lines.
int piece_count(const LessonPuzzle& puzzle);
const std::string& piece_text(const LessonPuzzle& puzzle, int piece);

/// Do the numbers of the pieces mean the same lines in both, and are they offered alike?
bool has_same_pieces(const LessonPuzzle& a, const LessonPuzzle& b);

/// A piece where the student has put it.
struct PlacedPiece {
    int piece = 0;
    int depth = 1;

    friend bool operator==(const PlacedPiece&, const PlacedPiece&) = default;
};

/// The pieces in the order that the lesson has.
std::vector<PlacedPiece> right_order(const LessonPuzzle& puzzle);

/// The function as far as these pieces, without the lines that are given after them.
std::vector<PuzzleLine> lines_above(const LessonPuzzle& puzzle,
                                    const std::vector<PlacedPiece>& placed);

/// The whole function with these pieces in it.
std::vector<PuzzleLine> function_of(const LessonPuzzle& puzzle,
                                    const std::vector<PlacedPiece>& placed);

/// Does the line begin a loop or a condition, which those one deeper belong to?
bool begins_block(std::string_view line);

/// The depth of a line that follows this one, unless it ends a block.
int depth_after(const PuzzleLine& line);

/// The function in C++: a line for each line, with braces at their ends.
std::string source_of(const std::vector<PuzzleLine>& lines);

/// The lines of C++ whose braces have lines of their own, indented by 4 blanks. Throws UsageError
/// for a line that is indented in a different way.
std::vector<PuzzleLine> lines_of_code(const std::vector<std::string_view>& code);

inline constexpr int deepest_puzzle = 6;
inline constexpr int most_puzzle_lines = 30;
inline constexpr int most_distractors = 8;

} // namespace rasterwalk
