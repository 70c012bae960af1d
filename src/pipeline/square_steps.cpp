#include "pipeline/square_steps.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// The quarters of the picture are divided off once.
constexpr int quarter_depth = 1;

} // namespace

int enclosing_square(const WarnockSquares& squares, int square, int depth) {
    while (squares[square].depth > depth)
        square = squares[square].parent;
    return square;
}

int next_square(const WarnockSquares& squares, int square, Granularity step) {
    const int depth = squares[square].depth;
    if (in_time(step) == Granularity::moment || depth < quarter_depth) return square + 1;
    switch (step) {
    case Granularity::moment:
    case Granularity::code:
    case Granularity::line:
        break;
    case Granularity::phase:
        square = enclosing_square(squares, square, std::max(depth - 1, quarter_depth));
        break;
    case Granularity::triangle:
        square = enclosing_square(squares, square, quarter_depth);
        break;
    }
    return squares.after(square);
}

int previous_square(const WarnockSquares& squares, int square, Granularity step) {
    if (square <= 0) return 0;
    const int before = square - 1;
    if (in_time(step) == Granularity::moment || squares[before].depth < quarter_depth)
        return before;
    const bool is_end = square >= squares.count();
    const int depth = is_end ? quarter_depth : squares[square].depth;
    switch (step) {
    case Granularity::moment:
    case Granularity::code:
        break;
    case Granularity::line:
        // A part of the same depth ends here, or the square before is the one it is a part of.
        return enclosing_square(squares, before, depth);
    case Granularity::phase:
        if (depth > quarter_depth) return squares[square].parent;
        break;
    case Granularity::triangle:
        break;
    }
    return enclosing_square(squares, before, quarter_depth);
}

int square_at(const WarnockSquares& squares, const Cursor& cursor) {
    if (cursor.pass > 0) return squares.count();
    return std::clamp(cursor.square, 0, squares.count());
}

Cursor cursor_at_square(const WarnockSquares& squares, int square) {
    return square < squares.count() ? moment_of_square(square) : cursor_end;
}

} // namespace rasterwalk
