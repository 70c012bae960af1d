#pragma once

// Judges the code of a puzzle by running it.

#include <string>
#include <vector>

#include "lessons/lesson_puzzle.h"
#include "lessons/puzzle_exam.h"

namespace rasterwalk {

/// What came of running a function.
struct PuzzleVerdict {
    bool is_right = false;
    std::string sentence; ///< what is wrong: plain text; empty if it is right
    int line = 0;         ///< of the function, from 1, where it is wrong; 0: it is not known
};

/// Asks a function all questions of an exam. A function is right if its answers are those of the
/// right one. One that is not understood, fails, or does not end is wrong.
/// @param lines the function
/// @param right one that answers all questions
PuzzleVerdict judge_function(const PuzzleExam& exam, const std::vector<PuzzleLine>& lines,
                             const std::vector<PuzzleLine>& right);

/// Judges the order in which a student has put the pieces. The puzzle's exam must exist.
PuzzleVerdict judge_order(const LessonPuzzle& puzzle, const std::vector<PlacedPiece>& placed);

} // namespace rasterwalk
