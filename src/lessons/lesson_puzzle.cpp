#include "lessons/lesson_puzzle.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr int indent = 4;

/// Lines that the student puts in place.
int own_line_count(const LessonPuzzle& puzzle) {
    return static_cast<int>(puzzle.lines.size()) - puzzle.given - puzzle.given_after;
}

} // namespace

bool is_gap(const LessonPuzzle& puzzle) {
    return own_line_count(puzzle) == 1;
}

int piece_count(const LessonPuzzle& puzzle) {
    return own_line_count(puzzle) + static_cast<int>(puzzle.distractors.size());
}

const std::string& piece_text(const LessonPuzzle& puzzle, int piece) {
    const int own = own_line_count(puzzle);
    if (piece < own) return puzzle.lines[static_cast<std::size_t>(puzzle.given + piece)].text;
    return puzzle.distractors[static_cast<std::size_t>(piece - own)];
}

bool has_same_pieces(const LessonPuzzle& a, const LessonPuzzle& b) {
    return a.lines == b.lines && a.given == b.given && a.given_after == b.given_after &&
           a.distractors == b.distractors && a.order == b.order;
}

std::vector<PlacedPiece> right_order(const LessonPuzzle& puzzle) {
    std::vector<PlacedPiece> placed;
    for (int piece = 0; piece < own_line_count(puzzle); ++piece)
        placed.push_back(
            {piece, puzzle.lines[static_cast<std::size_t>(puzzle.given + piece)].depth});
    return placed;
}

std::vector<PuzzleLine> lines_above(const LessonPuzzle& puzzle,
                                    const std::vector<PlacedPiece>& placed) {
    std::vector<PuzzleLine> lines(puzzle.lines.begin(), puzzle.lines.begin() + puzzle.given);
    for (const PlacedPiece& one : placed)
        lines.push_back({piece_text(puzzle, one.piece), one.depth});
    return lines;
}

std::vector<PuzzleLine> function_of(const LessonPuzzle& puzzle,
                                    const std::vector<PlacedPiece>& placed) {
    std::vector<PuzzleLine> lines = lines_above(puzzle, placed);
    lines.insert(lines.end(), puzzle.lines.end() - puzzle.given_after, puzzle.lines.end());
    return lines;
}

bool begins_block(std::string_view line) {
    return !line.ends_with(';');
}

int depth_after(const PuzzleLine& line) {
    return line.depth + (begins_block(line.text) ? 1 : 0);
}

std::string source_of(const std::vector<PuzzleLine>& lines) {
    std::string source;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const PuzzleLine& line = lines[i];
        const int next = i + 1 < lines.size() ? lines[i + 1].depth : 0;
        source.append(static_cast<std::size_t>(indent * line.depth), ' ').append(line.text);
        const int inside = depth_after(line);
        if (begins_block(line.text)) source += " {";
        source.append(static_cast<std::size_t>(std::max(inside - next, 0)), '}').append("\n");
    }
    return source;
}

std::vector<PuzzleLine> lines_of_code(const std::vector<std::string_view>& code) {
    std::vector<PuzzleLine> lines;
    for (const std::string_view line : code) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text == "{" || text == "}") continue;
        const auto blanks = static_cast<int>(text.data() - line.data());
        if (blanks % indent != 0)
            throw UsageError(
                fmt::format("the line {} must be indented by {} blanks for each brace.",
                            in_quotes(text), indent));
        lines.push_back({std::string(text), blanks / indent});
    }
    return lines;
}

} // namespace rasterwalk
