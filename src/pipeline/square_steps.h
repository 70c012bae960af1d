#pragma once

// How time runs through the squares of a picture. Each square is one moment; a divided one comes
// before its parts, and each part before the next one, with everything in it.

#include "pipeline/timeline.h"
#include "pipeline/warnock_squares.h"

namespace rasterwalk {

/// Where a step of this size leads from a square: `moment` to the next one; `line` past everything
/// in it; `phase` past the square that it is a part of; `triangle` past the quarter of the picture
/// that it is in. The whole picture is a step by itself, whatever the size.
/// @return count() after the last one
int next_square(const WarnockSquares& squares, int square, Granularity step);

/// And back: `line` to the part before it, or to the square that it is a part of; `phase` to the
/// square that it is a part of; `triangle` to the beginning of its quarter of the picture, or of
/// the one before.
/// @param square 0 up to count()
/// @return 0 before the first one
int previous_square(const WarnockSquares& squares, int square, Granularity step);

/// The square of this depth of division that a square is, or is in.
/// @param depth at most its own
int enclosing_square(const WarnockSquares& squares, int square, int depth);

/// The square of a cursor in time: its own; 0 for one from a frame without squares; count() at the
/// end.
int square_at(const WarnockSquares& squares, const Cursor& cursor);

/// The moment of a square; the end for count().
Cursor cursor_at_square(const WarnockSquares& squares, int square);

} // namespace rasterwalk
