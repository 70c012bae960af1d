#include "lessons/puzzle_desk.h"

#include <algorithm>
#include <iterator>

namespace rasterwalk {

PuzzleDesk new_desk(const LessonPuzzle& puzzle) {
    return {{}, puzzle.order};
}

PuzzleDesk solved_desk(const LessonPuzzle& puzzle) {
    PuzzleDesk desk = new_desk(puzzle);
    for (const PlacedPiece& one : right_order(puzzle))
        put_piece(puzzle, desk, one.piece, piece_count(puzzle), one.depth);
    return desk;
}

int place_of_piece(const PuzzleDesk& desk, int piece) {
    const auto found = std::find_if(desk.used.begin(), desk.used.end(),
                                    [&](const PlacedPiece& one) { return one.piece == piece; });
    return found == desk.used.end() ? -1 : static_cast<int>(found - desk.used.begin());
}

int deepest_at(const LessonPuzzle& puzzle, const PuzzleDesk& desk, int place, int piece) {
    std::vector<PlacedPiece> above;
    for (const PlacedPiece& one : desk.used) {
        if (static_cast<int>(above.size()) == place) break;
        if (one.piece != piece) above.push_back(one);
    }
    return std::min(depth_after(lines_above(puzzle, above).back()), deepest_puzzle);
}

void put_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int place, int depth) {
    const int deepest = deepest_at(puzzle, desk, place, piece);
    if (is_gap(puzzle)) desk = new_desk(puzzle);
    std::erase(desk.left, piece);
    std::erase_if(desk.used, [&](const PlacedPiece& one) { return one.piece == piece; });
    const int last = static_cast<int>(desk.used.size());
    desk.used.insert(desk.used.begin() + std::clamp(place, 0, last),
                     {piece, std::clamp(depth, 1, deepest)});
}

void take_piece_out(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece) {
    std::erase_if(desk.used, [&](const PlacedPiece& one) { return one.piece == piece; });
    desk.left.clear();
    std::copy_if(puzzle.order.begin(), puzzle.order.end(), std::back_inserter(desk.left),
                 [&](int one) { return place_of_piece(desk, one) < 0; });
}

void move_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int up) {
    const int place = place_of_piece(desk, piece), last = static_cast<int>(desk.used.size()) - 1;
    if (place < 0) {
        if (up > 0) put_piece(puzzle, desk, piece, last + 1, deepest_puzzle);
    } else if (up < 0 && place == last) {
        take_piece_out(puzzle, desk, piece);
    } else {
        const int depth = desk.used[static_cast<std::size_t>(place)].depth;
        put_piece(puzzle, desk, piece, std::max(place - up, 0), depth);
    }
}

void indent_piece(const LessonPuzzle& puzzle, PuzzleDesk& desk, int piece, int more) {
    const int place = place_of_piece(desk, piece);
    if (place < 0) return;
    const int depth = desk.used[static_cast<std::size_t>(place)].depth;
    put_piece(puzzle, desk, piece, place, depth + more);
}

} // namespace rasterwalk
