#pragma once

// The pieces of a puzzle as a student has laid them out.

#include <vector>

#include "lessons/lesson_puzzle.h"

namespace rasterwalk {

struct PuzzleDesk {
    std::vector<PlacedPiece> used; ///< in the function, after the given lines
    std::vector<int> left;         ///< pieces that are not used, in the order they are offered

    friend bool operator==(const PuzzleDesk&, const PuzzleDesk&) = default;
};

/// Nothing is in place.
PuzzleDesk new_desk(const LessonPuzzle& puzzle);

/// All lines are in their places.
PuzzleDesk solved_desk(const LessonPuzzle& puzzle);

/// Where a piece is in the function; -1: it is not used.
int place_of_piece(const PuzzleDesk& desk, int piece);

/// How deep a line may be at a place of the function: as deep as the line above it asks for.
/// @param piece is not counted if it is above
int deepest_at(const LessonPuzzle& puzzle, const PuzzleDesk& desk, int place, int piece);

/// Moves a piece to a place in the function, counted without the piece itself. A place behind the
/// last line is the one after it.
/// @param depth is brought between 1 and deepest_at()
void put_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int place, int depth);

/// Puts a piece back among those that are not used.
void take_piece_out(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece);

/// Moves a piece one line up (1) or down (-1): from those that are not used to the end of the
/// function, and from its end to them.
void move_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int up);

/// Indents a piece of the function by one more, or by one less.
void indent_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int more);

} // namespace rasterwalk
