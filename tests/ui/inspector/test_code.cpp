// The tab of the lab's code: it follows the moment, steps both ways by line, runs to a line or a
// condition, and shows the line that a mistake has put there with the right one.

#include <algorithm>
#include <string>
#include <vector>

#include "session/walk.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/code.h"
#include "ui/ui.h"
#include "ui/widgets/code_entries.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The bench's triangle, at the beginning of its first edge, with its code open.
void open_code(Driver& driver, const Cursor& at) {
    driver.hand.click("stage.rows");
    go_to(driver.ui.session, at);
    driver.hand.frames(2);
    driver.open("code");
    driver.hand.rest();
    REQUIRE(driver.ui.code.is_ready);
}

std::string words_shown(Driver& driver, const std::string& name) {
    return driver.hand.find(name).text;
}

std::string place_now(Driver& driver) {
    return to_text(driver.ui.session.cursor) + " + " + std::to_string(driver.ui.code.place.lines);
}

/// The number of the line of the file shown that has these words in it.
int line_number(Driver& driver, const std::string& words) {
    const std::vector<ChosenLine>& lines = driver.ui.code.walk.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].text.find(words) == std::string::npos) continue;
        return static_cast<int>(i) + 2 - file_around(lines, static_cast<int>(i) + 1).first;
    }
    return 0;
}

const Cursor edge_begin{0, Phase::edges, 0, 0};

} // namespace

TEST_CASE("The code shows the line of the moment, and follows it") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    CHECK(words_shown(driver, "group.code").substr(0, 9) == "rows.cpp:");
    const int line = line_number(driver, "int row = line[k].y - ymin;");
    CHECK(words_shown(driver, "group.code") == "rows.cpp:" + std::to_string(line));
    const std::string before = words_shown(driver, "group.code");
    driver.hand.press(key::period);
    CHECK(place_now(driver) == "t0/e0/s1 + 0");
    CHECK(words_shown(driver, "group.code") == before);
    go_to(driver.ui.session, Cursor{0, Phase::vertices, 1, 0});
    driver.hand.frames(3);
    CHECK(words_shown(driver, "group.code").substr(0, 9) == "draw.cpp:");
}

TEST_CASE("Lines are stepped in both directions, by button and by key") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    for (int line = 1; line <= 3; ++line) {
        driver.hand.click("code.step");
        CHECK(place_now(driver) == "t0/e0/s0 + " + std::to_string(line));
    }
    for (int line = 2; line >= 0; --line) {
        driver.hand.click("code.back");
        CHECK(place_now(driver) == "t0/e0/s0 + " + std::to_string(line));
    }
    driver.hand.click("step.code");
    driver.hand.press(key::period);
    CHECK(place_now(driver) == "t0/e0/s0 + 1");
    driver.hand.press(key::comma);
    driver.hand.press(key::comma);
    // Back over the beginning of a moment, to the last line of the one before.
    CHECK(driver.ui.session.cursor.phase == Phase::vertices);
    CHECK(driver.ui.code.place.lines > 0);
    driver.hand.press(key::period);
    CHECK(place_now(driver) == "t0/e0/s0 + 0");
}

TEST_CASE("A click on a line runs to its next beginning, and the time axis follows") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    const std::string line =
        "code.line." + std::to_string(line_number(driver, "rightPixels[row] = line[k]"));
    driver.hand.click(line);
    CHECK(driver.ui.session.cursor == edge_begin);
    CHECK(driver.ui.code.place.lines > 0);
    driver.hand.click("code.step");
    // What was written stands at its end.
    CHECK(words_shown(driver, line).find("{x ") == 0);
    const std::string sample = words_shown(driver, line);
    driver.hand.click(line);
    CHECK(driver.ui.session.cursor > edge_begin);
    // A line that does not come again.
    const int gone = line_number(driver, "int rows = ymax - ymin + 1;");
    driver.hand.click("code.line." + std::to_string(gone));
    CHECK(driver.ui.session.cursor == cursor_end);
    CHECK(driver.ui.session.notice.find("not reached again") != std::string::npos);
    CHECK(driver.hand.is_visible("code.ended"));
    driver.hand.click("code.back");
    CHECK(driver.ui.session.cursor != cursor_end);
}

TEST_CASE("The code stops where a line's condition holds") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    const int line = line_number(driver, "int row = line[k].y - ymin;");
    driver.hand.click("code.number." + std::to_string(line));
    driver.hand.enter("code.condition", "kk == 3");
    CHECK(words_shown(driver, "code.condition_fault").find("kk") != std::string::npos);
    CHECK(driver.ui.code.conditions.empty());
    driver.hand.enter("code.condition", "k == 3");
    CHECK(driver.ui.code.conditions.size() == 1);
    driver.hand.click("code.run");
    CHECK(place_now(driver) == "t0/e0/s3 + 0");
    driver.hand.click("code.run");
    CHECK(place_now(driver) == "t0/e1/s3 + 0");
    driver.hand.click("code.number." + std::to_string(line));
    driver.hand.click("code.remove");
    CHECK(driver.ui.code.conditions.empty());
    CHECK_FALSE(driver.hand.is_visible("code.run"));
}

TEST_CASE("A line of a mistake has the right one below it") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.ui.session.a.settings.depth_test = DepthTest::reversed;
    go_to(driver.ui.session, Cursor{2, Phase::rows, 3, 5});
    driver.hand.frames(3);
    driver.open("code");
    driver.hand.rest();
    const int line = line_number(driver, "if (p.zinv < depthBuffer");
    REQUIRE(line > 0);
    CHECK(words_shown(driver, "code.right." + std::to_string(line)).find("p.zinv > depthBuffer") !=
          std::string::npos);
}

TEST_CASE("A number of the row table is lit together with the line that has it") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    const int line = line_number(driver, "leftPixels[row] = line[k];");
    driver.hand.click("code.line." + std::to_string(line));
    driver.hand.click("code.step");
    const RowHistory& history = driver.ui.results.a.rows;
    const std::vector<CodeShown> variables =
        driver.ui.code.walk.machine().variables(driver.ui.code.walk.machine().calls().back());
    const auto row = std::find_if(variables.begin(), variables.end(),
                                  [](const CodeShown& one) { return one.name == "row"; });
    REQUIRE(row != variables.end());
    const int index = std::stoi(row->value), picture_row = history.rows.first_row + index;
    driver.hand.hover("code.line." + std::to_string(line));
    driver.hand.frames(2);
    REQUIRE(driver.ui.code.pointed.size() == 1);
    CHECK(driver.ui.code.pointed[0].index == index);
    CHECK(driver.ui.code.pointed[0].is_left);
    CHECK(is_pointed_in_code(driver.ui, picture_row, true));
    CHECK_FALSE(is_pointed_in_code(driver.ui, picture_row, false));
    CHECK_FALSE(is_pointed_in_code(driver.ui, picture_row + 1, true));
    // A line without an entry lights none.
    driver.hand.hover("code.line." +
                      std::to_string(line_number(driver, "int row = line[k].y - ymin;")));
    driver.hand.frames(2);
    CHECK(driver.ui.code.pointed.empty());
    // And from the table to the line.
    driver.hand.hover("canvas.rows." + std::to_string(picture_row));
    driver.hand.frames(2);
    CHECK(is_pointed_in_table(driver.ui, {index, true}));
    CHECK_FALSE(is_pointed_in_table(driver.ui, {index + 1, true}));
}

TEST_CASE("Callers are shown with the line that calls") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    driver.hand.click("code.call.1");
    CHECK(words_shown(driver, "group.code").substr(0, 9) == "draw.cpp:");
    driver.hand.click("code.step");
    CHECK(words_shown(driver, "group.code").substr(0, 9) == "rows.cpp:");
}

TEST_CASE("Where a setting has no lines, the code says so") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.ui.session.a.settings.depth_test = DepthTest::raced;
    driver.hand.frames(3);
    driver.open("code");
    CHECK(words_shown(driver, "code.missing").find("two threads") != std::string::npos);
    // Steps by line are moments there.
    driver.hand.click("step.code");
    driver.hand.press(key::home);
    const Cursor before = driver.ui.results.a.cursor;
    driver.hand.press(key::period);
    CHECK(driver.ui.results.a.cursor > before);
}

TEST_CASE("What is just another way to do it is not called a mistake") {
    Driver driver("one-triangle.toml");
    driver.ui.session.a.settings.line = LineAlgorithm::bresenham;
    open_code(driver, edge_begin);
    const std::vector<ChosenLine>& lines = driver.ui.code.walk.lines();
    CHECK(std::all_of(lines.begin(), lines.end(),
                      [](const ChosenLine& line) { return !line.is_mistake; }));
}

TEST_CASE("A condition that is set while time plays, or that fails, does no harm") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    driver.hand.click("step.code");
    driver.ui.session.play.speed = {SpeedUnit::steps, 10.0};
    const int line = line_number(driver, "int row = line[k].y - ymin;");
    driver.hand.click("code.number." + std::to_string(line));
    driver.hand.press(key::space);
    driver.hand.enter("code.condition", "nonsense");
    driver.hand.frames(5);
    CHECK(driver.ui.session.cursor != cursor_end);
    driver.hand.enter("code.condition", "leftPixels[100].x > 3");
    driver.hand.frames(5);
    CHECK(driver.ui.session.notice.find("There is no element [100]") != std::string::npos);
    CHECK(driver.ui.code.conditions.empty());
    driver.hand.frames(2);
    CHECK(driver.ui.code.is_ready);
}

TEST_CASE("A condition whose names are gone is removed, and one whose line is gone waits") {
    Driver driver;
    driver.hand.click("stage.vertex_light");
    go_to(driver.ui.session, Cursor{12, Phase::vertices, 0, 0});
    driver.hand.frames(3);
    driver.open("code");
    driver.hand.rest();
    driver.hand.click("code.step");
    const int line = line_number(driver, "p.illumination = ReflectedLight");
    REQUIRE(line > 0);
    driver.hand.click("code.number." + std::to_string(line));
    driver.hand.enter("code.condition", "p.zinv > 100");
    REQUIRE(driver.ui.code.conditions.size() == 1);
    // The line is not there: the condition waits.
    driver.hand.click("stage.depth");
    driver.hand.frames(3);
    CHECK(driver.ui.code.is_ready);
    CHECK(driver.ui.code.conditions.size() == 1);
    driver.hand.click("stage.vertex_light");
    driver.hand.frames(3);
    // A line of both stages, and a member that a pixel has only in one.
    const int both = line_number(driver, "p.zinv = 0;");
    driver.hand.click("code.number." + std::to_string(both));
    driver.hand.enter("code.condition", "p.illumination.x > 100");
    REQUIRE(driver.ui.code.conditions.size() == 2);
    driver.hand.click("stage.depth");
    driver.hand.frames(3);
    CHECK(driver.ui.session.notice.find("illumination") != std::string::npos);
    CHECK(driver.ui.code.conditions.empty());
    CHECK(driver.ui.code.is_ready);
}

TEST_CASE("Time plays by lines") {
    Driver driver("one-triangle.toml");
    open_code(driver, edge_begin);
    driver.hand.click("step.code");
    driver.ui.session.play.speed = {SpeedUnit::steps, 10.0};
    driver.hand.press(key::space);
    driver.hand.frames(61);
    driver.hand.press(key::space);
    const CodePlace played = driver.ui.code.place;
    CHECK(!(played == CodePlace{edge_begin, 0}));
    go_to(driver.ui.session, edge_begin);
    driver.hand.frames(3);
    for (int line = 0; line < 10; ++line)
        driver.hand.click("code.step");
    CHECK(driver.ui.code.place == played);
}

} // namespace rasterwalk
