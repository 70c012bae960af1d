#include "lessons/puzzle_block.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "base/toml_block.h"
#include "lessons/lesson_blocks.h"
#include "lessons/puzzle_exam.h"

namespace rasterwalk {

namespace {

/// What is wrong with the lines of a function; empty: nothing.
std::string fault_of_lines(const LessonPuzzle& puzzle) {
    const std::vector<PuzzleLine>& lines = puzzle.lines;
    if (lines.size() > static_cast<std::size_t>(most_puzzle_lines))
        return fmt::format("the code may have at most {} lines besides braces.", most_puzzle_lines);
    if (lines.front().depth != 0)
        return "the first line must name the function and must not be indented.";
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const int depth = lines[i].depth;
        if (depth < 1 || depth > deepest_puzzle || depth > depth_after(lines[i - 1]))
            return fmt::format("the line {} is not indented as its braces ask for.",
                               in_quotes(lines[i].text));
    }
    if (puzzle.given + puzzle.given_after >= static_cast<int>(lines.size()))
        return "at least one line must be left to put in place.";
    return {};
}

} // namespace

LessonPuzzle read_puzzle(const toml::table& table, int line,
                         const std::vector<std::string_view>& code, int code_line,
                         FaultList& faults) {
    TomlBlock block(table, line, "the block 'order'", faults);
    LessonPuzzle puzzle;
    puzzle.line = line;
    puzzle.code_line = code_line;
    TomlKeys keys;
    keys["id"] = [&](const toml::node& n) { puzzle.id = read_question_id(block, n); };
    keys["asks"] = [&](const toml::node& n) {
        puzzle.exam = block.word(n, "exam of a function", exam_names());
    };
    keys["given"] = [&](const toml::node& n) {
        puzzle.given = block.whole(n, 1, most_puzzle_lines);
    };
    keys["given_after"] = [&](const toml::node& n) {
        puzzle.given_after = block.whole(n, 0, most_puzzle_lines);
    };
    keys["because"] = [&](const toml::node& n) { puzzle.because = block.text(n); };
    keys["distractors"] = [&](const toml::node& n) {
        block.for_each_text(n, most_distractors, [&](const std::string& text) {
            puzzle.distractors.emplace_back(trimmed(text));
        });
    };
    block.read(keys);
    for (const char* key : {"id", "asks", "distractors"})
        block.require(key);
    faults.attempt(code_line, [&] {
        puzzle.lines = lines_of_code(code);
        if (puzzle.lines.empty()) throw UsageError("the block of code has no lines.");
        const std::string wrong = fault_of_lines(puzzle);
        if (wrong.empty()) return;
        puzzle.lines.clear();
        throw UsageError(wrong);
    });
    if (puzzle.id.empty() || puzzle.exam.empty()) puzzle.lines.clear();
    return puzzle;
}

} // namespace rasterwalk
