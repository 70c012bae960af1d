// A puzzle in the window: lines are clicked, dragged and moved by keys, and then run.

#include <string>
#include <vector>

#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

constexpr const char* of_interpolate = "lesson.puzzle.interpolate";

struct Puzzler {
    Driver driver;
    Ui& ui = driver.ui;
    const LessonPuzzle* puzzle = nullptr;

    explicit Puzzler(ImVec2 window = {1600, 1000}, float text_scale = 1.0f)
        : driver("lab-room.toml", window, text_scale) {
        const Lesson* const lesson = ui.lesson.lessons.find("04-edges");
        REQUIRE(lesson != nullptr);
        puzzle = &lesson->puzzles.at(0);
        open_lesson(ui, "04-edges", puzzle->step);
        driver.hand.leave();
        if (ui.lesson.is_strip) driver.hand.click("lesson.card.1");
        driver.hand.rest();
    }
    static std::string piece(int number) {
        return std::string(of_interpolate) + ".piece." + std::to_string(number);
    }
    const PuzzleDesk& desk() { return ui.lesson.puzzles.at("interpolate").desk; }
    bool is_done() const { return ui.lesson.progress.is_task_done("04-edges", "interpolate"); }
    bool is_there(const std::string& name) const { return ui.widgets.count(name) > 0; }
    void click(const std::string& name) {
        driver.hand.click(name);
        driver.hand.leave();
    }
    /// Drags a piece so that its middle comes to this height, and to the right.
    void drag(int number, float to, float right) {
        driver.hand.hover(piece(number));
        const WidgetPlace place = driver.hand.find(piece(number));
        const float x = 0.5f * (place.top_left.x + place.bottom_right.x);
        const float y = 0.5f * (place.top_left.y + place.bottom_right.y);
        play_pointer({x, y});
        driver.hand.frames(2);
        play_mouse_button(0, true);
        driver.hand.frames(2);
        for (const float share : {0.25f, 0.5f, 0.75f, 1.0f, 1.0f}) {
            play_pointer({x + share * right, y + share * (to - y)});
            driver.hand.frames(2);
        }
        play_mouse_button(0, false);
        driver.hand.frames(2);
        driver.hand.leave();
    }
};

/// A lesson with a puzzle of these lines and distractors.
std::string lesson_with_puzzle(const std::string& lines, const std::string& distractors) {
    return test::lesson_head() +
           "Words.\n\n## A step\n\n<!-- order\nid = \"line\"\nasks = \"line\"\ndistractors = [" +
           distractors + "]\n-->\n> **Put in order.** Build it.\n\n```cpp\n" +
           "void DrawLine(int x, int y, int l, int s)\n{\n" + lines + "}\n```\n";
}

} // namespace

TEST_CASE("Lines that are clicked in the right order solve a puzzle, in each size of window") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Puzzler p(window.size, window.text_scale);
        const std::string name = of_interpolate;
        CHECK(p.desk() == new_desk(*p.puzzle));
        p.click(Puzzler::piece(0));
        p.click(name + ".run");
        CHECK_FALSE(p.is_done());
        CHECK(shown_text(p.driver, name + ".verdict") ==
              "From (4, 2) to (1, 8) with 4 samples: result[0].x is 0 and should be 4.");
        for (std::size_t i = 1; i < right_order(*p.puzzle).size(); ++i)
            p.click(Puzzler::piece(static_cast<int>(i)));
        // The verdict was about other lines.
        CHECK_FALSE(p.is_there(name + ".verdict"));
        CHECK(p.desk().used == right_order(*p.puzzle));
        p.click(name + ".run");
        CHECK(p.is_done());
        CHECK(p.is_there(name + ".because"));
        CHECK_FALSE(p.is_there(name + ".run"));
        // It is still there when the lesson is opened again.
        open_lesson(p.ui, "05-row-table", 0);
        p.driver.hand.rest();
        open_lesson(p.ui, "04-edges", p.puzzle->step);
        p.driver.hand.leave();
        if (p.ui.lesson.is_strip) p.click("lesson.card.1");
        p.driver.hand.rest();
        CHECK(p.desk().used == right_order(*p.puzzle));
        CHECK_FALSE(p.is_there(name + ".run"));
    }
}

TEST_CASE("A line that is dragged goes where it is dropped, as deep as it is moved to the side") {
    Puzzler p;
    p.click(Puzzler::piece(4)); // the loop
    p.click(Puzzler::piece(5)); // in it
    p.click(Puzzler::piece(6));
    REQUIRE(p.desk().used == std::vector<PlacedPiece>{{4, 1}, {5, 2}, {6, 2}});
    const auto top_of = [&](int piece) {
        return p.driver.hand.find(Puzzler::piece(piece)).top_left.y;
    };
    p.drag(6, top_of(5) + 1.0f, 0.0f);
    CHECK(p.desk().used == std::vector<PlacedPiece>{{4, 1}, {6, 2}, {5, 2}});
    p.drag(5, top_of(5) + 4.0f, -16.0f);
    CHECK(p.desk().used == std::vector<PlacedPiece>{{4, 1}, {6, 2}, {5, 1}});
    // From those that are not used to a place between two lines, and back.
    p.drag(0, top_of(4) + 1.0f, -40.0f);
    CHECK(p.desk().used == std::vector<PlacedPiece>{{0, 1}, {4, 1}, {6, 2}, {5, 1}});
    p.drag(0, top_of(p.desk().left.back()) + 4.0f, 0.0f);
    CHECK(p.desk().used == std::vector<PlacedPiece>{{4, 1}, {6, 2}, {5, 1}});
    CHECK(p.desk().left.size() == p.puzzle->order.size() - 3);
    p.click(std::string(of_interpolate) + ".start_over");
    CHECK(p.desk() == new_desk(*p.puzzle));
}

TEST_CASE("The keyboard alone puts lines in order and runs them") {
    Puzzler p;
    for (std::size_t i = 0; i < right_order(*p.puzzle).size(); ++i) {
        REQUIRE(p.driver.tab_to(Puzzler::piece(static_cast<int>(i))));
        p.driver.hand.press(key::up);
    }
    CHECK(p.desk().used == right_order(*p.puzzle));
    // The ring stays on the line that it moves.
    p.driver.hand.press(key::left);
    CHECK(p.desk().used.back() == PlacedPiece{6, 1});
    p.driver.hand.press(key::up);
    CHECK(p.desk().used.back().piece == 5);
    p.driver.hand.press(key::down);
    p.driver.hand.press(key::right);
    CHECK(p.desk().used == right_order(*p.puzzle));
    p.driver.hand.press(key::down);
    CHECK(p.desk().left.size() == 4);
    p.driver.hand.press(key::up);
    REQUIRE(p.driver.tab_to(std::string(of_interpolate) + ".run"));
    p.driver.hand.press(key::enter);
    p.driver.hand.rest();
    CHECK(p.is_done());
}

TEST_CASE("A puzzle whose lines are edited while they are in place is laid out again") {
    const std::string loop = "    for (int i = 0; i <= l; ++i)\n        Plot(x + i, y);\n";
    const test::TemporaryFolder folder;
    folder.write("01-line.md",
                 lesson_with_puzzle("    int d = 0;\n" + loop, R"("++x;", "++y;", "d += s;")"));
    Driver driver;
    Ui& ui = driver.ui;
    ui.lesson.lessons.read_folder(folder.file(""));
    open_lesson(ui, "01-line", 1);
    driver.hand.rest();
    // The last distractor and the last line are in the function.
    for (const char* const piece : {"5", "2"}) {
        driver.hand.click(std::string("lesson.puzzle.line.piece.") + piece);
        driver.hand.leave();
    }
    const PuzzleView& view = ui.lesson.puzzles.at("line");
    REQUIRE(view.desk.used.size() == 2);
    // Words alone leave them there.
    std::string reworded =
        lesson_with_puzzle("    int d = 0;\n" + loop, R"("++x;", "++y;", "d += s;")");
    reworded.replace(reworded.find("Build it."), 9, "Now build the function.");
    folder.write("01-line.md", reworded);
    driver.hand.rest();
    CHECK(view.desk.used.size() == 2);
    folder.write("01-line.md", lesson_with_puzzle(loop, R"("++x;")"));
    driver.hand.rest();
    const Lesson* const lesson = open_lesson_of(ui);
    REQUIRE(lesson != nullptr);
    REQUIRE(lesson->faults.empty());
    CHECK(piece_count(lesson->puzzles.at(0)) == 3);
    CHECK(view.desk == new_desk(lesson->puzzles.at(0)));
    // As many pieces, one of which says something else.
    driver.hand.click("lesson.puzzle.line.piece.0");
    driver.hand.leave();
    REQUIRE(view.desk.used.size() == 1);
    folder.write("01-line.md", lesson_with_puzzle(loop, R"("y += 1;")"));
    driver.hand.rest();
    CHECK(view.desk.used.empty());
    CHECK(view.desk.left.size() == 3);
}

} // namespace rasterwalk
