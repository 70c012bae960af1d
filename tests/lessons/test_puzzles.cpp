// Puzzles: how they are read, laid out and judged.

#include <algorithm>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/lesson_check.h"
#include "lessons/progress.h"
#include "lessons/puzzle_desk.h"
#include "lessons/puzzle_judge.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"

using namespace rasterwalk;

namespace {

constexpr const char* good_block = R"(
<!-- order
id = "line"
asks = "line"
distractors = ["int d = 0;", "d += s;"]
because = "It is."
-->
> **Put in order.** Build it.

)";

constexpr const char* good_code = R"(```cpp
void DrawLine(int x, int y, int l, int s)
{
    int d = 2 * s - l;
    for (int i = 0; i <= l; ++i)
    {
        Plot(x, y);
        if (d >= 0)
        {
            ++y;
            d -= 2 * l;
        }
        ++x;
        d += 2 * s;
    }
}
```
)";

Lesson lesson_with(const std::string& block, const std::string& code) {
    return parse_lesson(test::lesson_head() + "Text.\n\n## A step\n" + block + code + "\nMore.\n",
                        "41-puzzle.md");
}

LessonPuzzle puzzle_of_line() {
    const Lesson lesson = lesson_with(good_block, good_code);
    REQUIRE(lesson.faults.empty());
    REQUIRE(lesson.puzzles.size() == 1);
    return lesson.puzzles.front();
}

std::string only_fault(const std::string& block, const std::string& code) {
    const Lesson lesson = lesson_with(block, code);
    CHECK(lesson.puzzles.empty());
    REQUIRE(lesson.faults.size() == 1);
    return lesson.faults.front().sentence;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    REQUIRE(at != text.npos);
    return text.replace(at, old.size(), by);
}

/// The right function with one line changed.
PuzzleVerdict verdict_with(const std::string& old, const std::string& by) {
    const LessonPuzzle puzzle = puzzle_of_line();
    std::vector<PuzzleLine> lines = puzzle.lines;
    for (PuzzleLine& line : lines) {
        if (line.text == old) line.text = by;
    }
    REQUIRE(lines != puzzle.lines);
    return judge_function(*find_exam("line"), lines, puzzle.lines);
}

} // namespace

TEST_CASE("A puzzle is read with its lines, their depths and its text") {
    const Lesson lesson = lesson_with(good_block, good_code);
    CHECK(lesson.faults.empty());
    REQUIRE(lesson.puzzles.size() == 1);
    const LessonPuzzle& puzzle = lesson.puzzles.front();
    CHECK(puzzle.text == "**Put in order.** Build it.");
    CHECK(puzzle.because == "It is.");
    CHECK(puzzle.step == 1);
    REQUIRE(puzzle.lines.size() == 9);
    CHECK(puzzle.lines[0] == PuzzleLine{"void DrawLine(int x, int y, int l, int s)", 0});
    CHECK(puzzle.lines[3] == PuzzleLine{"Plot(x, y);", 2});
    CHECK(puzzle.lines[6] == PuzzleLine{"d -= 2 * l;", 3});
    CHECK(piece_count(puzzle) == 10);
    CHECK(piece_text(puzzle, 0) == "int d = 2 * s - l;");
    CHECK(piece_text(puzzle, 9) == "d += s;");
    // Every piece is offered once, and not in the right order.
    std::vector<int> sorted = puzzle.order;
    std::sort(sorted.begin(), sorted.end());
    CHECK(sorted == std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    CHECK(sorted != puzzle.order);
    // The text goes on after the code.
    REQUIRE(lesson.steps[1].parts.size() == 2);
    CHECK(lesson.steps[1].parts[0].kind == LessonPart::Kind::puzzle);
    CHECK(lesson.steps[1].parts[1].text == "More.");
    CHECK(check_lesson(lesson, empty_session()).size() ==
          check_lesson(
              parse_lesson(test::lesson_head() + "Text.\n\n## A step\nMore.\n", "41-puzzle.md"),
              empty_session())
              .size());
}

TEST_CASE("What is wrong with a puzzle is said") {
    CHECK(only_fault(good_block, "") == "the text of the block 'order' must be followed by its "
                                        "code, between lines of ```.");
    for (const char* const empty : {"```cpp\n```\n", "```cpp\n\n{\n}\n```\n"})
        CHECK(only_fault(good_block, empty) == "the block of code has no lines.");
    CHECK(only_fault(good_block, replaced(good_code, "    int d", "   int d")) ==
          "the line 'int d = 2 * s - l;' must be indented by 4 blanks for each brace.");
    CHECK(only_fault(good_block, replaced(good_code, "    int d", "        int d")) ==
          "the line 'int d = 2 * s - l;' is not indented as its braces ask for.");
    CHECK(only_fault(replaced(good_block, "id = \"line\"", "given = 9\nid = \"line\""),
                     good_code) == "at least one line must be left to put in place.");
    CHECK(only_fault(replaced(good_block, "asks = \"line\"", "asks = \"lime\""), good_code)
              .starts_with("there is no exam of a function 'lime'"));
}

TEST_CASE("A puzzle that is not right as it stands is a fault of the lesson") {
    const Lesson lesson = lesson_with(good_block, replaced(good_code, "++x;", "++z;"));
    const std::vector<Fault> faults = check_lesson(lesson, empty_session());
    CHECK(std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
        return fault.sentence.find("the code of 'line' does not pass its own questions.") == 0;
    }));
}

TEST_CASE("The source has a line for each line, and a brace for each that closes") {
    CHECK(
        source_of({{"void f()", 0}, {"for (;;)", 1}, {"if (a)", 2}, {"b;", 3}, {"while (c)", 1}}) ==
        "void f() {\n    for (;;) {\n        if (a) {\n            b;}}\n    while (c) {}}\n");
}

TEST_CASE("The judge names the first wrong answer, or the line and what is wrong with it") {
    CHECK(verdict_with("++x;", "x += 1;").is_right);
    const PuzzleVerdict wrong = verdict_with("int d = 2 * s - l;", "int d = 0;");
    CHECK_FALSE(wrong.is_right);
    CHECK(wrong.line == 0);
    CHECK(wrong.sentence ==
          "From (0, 0), 8 to the right and 3 down: the y of pixel 1 is 1 and should be 0.");
    const PuzzleVerdict missing =
        verdict_with("for (int i = 0; i <= l; ++i)", "for (int i = 0; i < l; ++i)");
    CHECK(missing.sentence ==
          "From (0, 0), 8 to the right and 3 down: the x of pixel 8 is missing.");
    const PuzzleVerdict more =
        verdict_with("for (int i = 0; i <= l; ++i)", "for (int i = 0; i <= l + 1; ++i)");
    CHECK(more.sentence ==
          "From (0, 0), 8 to the right and 3 down: the x of pixel 9 is one too many.");
    const PuzzleVerdict unknown = verdict_with("++x;", "++z;");
    CHECK(unknown.line == 8);
    CHECK(unknown.sentence.starts_with("`z` is not declared here."));
    const PuzzleVerdict endless =
        verdict_with("for (int i = 0; i <= l; ++i)", "for (int i = 0; 0 <= l; ++i)");
    CHECK_FALSE(endless.is_right);
    CHECK(endless.line >= 3);
    CHECK(endless.sentence == "The loop around this line never ends.");
    const PuzzleVerdict failing = verdict_with("++x;", "x += 1 / (i - 2);");
    CHECK(failing.line == 8);
    CHECK(failing.sentence ==
          "From (0, 0), 8 to the right and 3 down: A whole number is divided by 0.");
    const PuzzleVerdict large = verdict_with("++x;", "vector<float> v(60000000);");
    CHECK(large.line == 8);
    CHECK(large.sentence == "From (0, 0), 8 to the right and 3 down: The vectors need more memory "
                            "than there is.");
    // A line under one that begins nothing.
    const LessonPuzzle puzzle = puzzle_of_line();
    std::vector<PlacedPiece> order = right_order(puzzle);
    ++order[1].depth;
    const PuzzleVerdict indented = judge_order(puzzle, order);
    CHECK(indented.line == 3);
    CHECK(indented.sentence.find("indented") != std::string::npos);
}

TEST_CASE("The judge names a pixel of a picture by its place") {
    // Without the depth test nothing but what is stored is right.
    const std::vector<PuzzleLine> right{{"void Draw(const vector<Pixel>& fragments)", 0},
                                        {"for (int y = 0; y < HEIGHT; ++y)", 1},
                                        {"for (int x = 0; x < WIDTH; ++x)", 2},
                                        {"depth[y][x] = 0;", 3}};
    std::vector<PuzzleLine> wrong = right;
    wrong.push_back({"depth[2][1] = 5;", 1});
    const PuzzleVerdict verdict = judge_function(*find_exam("depth"), wrong, right);
    CHECK(verdict.sentence == "A far fragment, then a near one, both on (0, 0): the depth of pixel "
                              "(1, 2) is 5 and should be 0.");
}

TEST_CASE("Pieces are put in place, moved, indented and taken out") {
    const LessonPuzzle puzzle = puzzle_of_line();
    PuzzleDesk desk = new_desk(puzzle);
    CHECK(desk.used.empty());
    CHECK(desk.left == puzzle.order);
    put_piece(puzzle, desk, 1, 99, deepest_puzzle); // the loop
    put_piece(puzzle, desk, 2, 99, deepest_puzzle); // goes into it
    CHECK(desk.used == std::vector<PlacedPiece>{{1, 1}, {2, 2}});
    CHECK(desk.left.size() == 8);
    indent_piece(puzzle, desk, 2, -1);
    CHECK(desk.used[1].depth == 1);
    indent_piece(puzzle, desk, 2, -1); // no further
    CHECK(desk.used[1].depth == 1);
    indent_piece(puzzle, desk, 2, 1);
    indent_piece(puzzle, desk, 2, 1);
    CHECK(desk.used[1].depth == 2);
    move_piece(puzzle, desk, 2, 1);
    CHECK(desk.used == std::vector<PlacedPiece>{{2, 1}, {1, 1}});
    move_piece(puzzle, desk, 2, 1); // it is at the top
    CHECK(desk.used.front().piece == 2);
    move_piece(puzzle, desk, 2, -1);
    CHECK(desk.used.back() == PlacedPiece{2, 1});
    move_piece(puzzle, desk, 2, -1); // out of the function
    CHECK(place_of_piece(desk, 2) == -1);
    move_piece(puzzle, desk, 1, -1);
    CHECK(desk == new_desk(puzzle));
    move_piece(puzzle, desk, 1, -1); // it is not in the function
    CHECK(desk == new_desk(puzzle));
    move_piece(puzzle, desk, 9, 1);
    CHECK(desk.used == std::vector<PlacedPiece>{{9, 1}});
    CHECK(solved_desk(puzzle).used == right_order(puzzle));
    CHECK(solved_desk(puzzle).left.size() == 2);
}

TEST_CASE("A puzzle counts like a task") {
    const Lesson lesson = lesson_with(good_block, good_code);
    Progress progress;
    CHECK(task_count(lesson) == 1);
    CHECK(score_of(progress, lesson).all == 1);
    CHECK(score_of(progress, lesson).solved == 0);
    progress.record_task(lesson.id, "line");
    CHECK(score_of(progress, lesson).solved == 1);
}
