#include <algorithm>

#include "inspect/row_history.h"
#include "support/samples.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("The row table fills as the cursor moves") {
    Driver driver("one-triangle.toml");
    driver.hand.click("walk.first");
    CHECK(driver.ui.results.a.rows.samples == 0);
    CHECK(driver.ui.results.a.rows.rows.is_empty_row(0));
    driver.hand.click("step.line");
    driver.hand.click("walk.step");
    driver.hand.click("walk.step");
    CHECK(driver.ui.results.a.rows.samples == 6);
    CHECK_FALSE(driver.ui.results.a.rows.rows.is_empty_row(5));
    CHECK(driver.ui.results.a.rows.rows.is_empty_row(6));
}

TEST_CASE("A click on a cell goes to the moment in which it was written") {
    Driver driver("one-triangle.toml");
    driver.hand.click("rows.12.left");
    const RowHistory& rows = driver.ui.results.a.rows;
    REQUIRE(rows.last);
    CHECK(rows.last->fragment.row == 12);
    CHECK(rows.last->write.left);
    CHECK(to_text(driver.ui.results.a.cursor) == "t0/e1/s5");
    driver.hand.press(key::left, {.alt = true});
    CHECK(driver.ui.results.a.cursor == cursor_end);
}

TEST_CASE("A row that is pointed at lights up in the picture, and vice versa") {
    Driver driver("one-triangle.toml");
    driver.hand.hover("rows.9");
    CHECK(driver.ui.inspector.hovered_row == 9);
    driver.hand.hover_picture(8, 11);
    REQUIRE(driver.ui.canvas.hovered_pixel);
    CHECK(driver.ui.canvas.hovered_pixel->y == 11);
    CHECK_FALSE(driver.ui.inspector.hovered_row);
}

TEST_CASE("On a projector the table scrolls together with what is below it, under its headers") {
    Driver driver("one-triangle.toml", {1024, 640}, 1.5f);
    driver.hand.press('3');
    driver.hand.press(key::end);
    driver.open("rows");
    driver.hand.leave();
    const float right = driver.ui.widgets.at("rows.header.right").bottom_right.x;
    CHECK(driver.ui.widgets.at("rows.15.right").bottom_right.x == Approx(right).margin(2.0));
    // After the writer's name there is room for the sign of what was replaced.
    CHECK(driver.hand.is_visible("rows.15.right_by"));
    CHECK(driver.ui.widgets.at("rows.15.right_by").bottom_right.x <
          driver.ui.widgets.at("rows.header.right by").bottom_right.x);
    driver.hand.find("rows.values"); // scrolls to it
    CHECK(driver.ui.widgets.at("rows.values").is_whole);
    CHECK(driver.ui.widgets.at("rows.header.right by").is_whole);
    CHECK_FALSE(driver.hand.is_visible("rows.5.left"));
}

TEST_CASE("The table is copied in the lab's own form") {
    Driver driver("one-triangle.toml");
    driver.hand.click("rows.copy");
    const std::string text = ImGui::GetClipboardText();
    CHECK(text.substr(0, text.find('\n')) == "Start: (10,5). End: (10,5).");
    CHECK(std::count(text.begin(), text.end(), '\n') == 11);
}

TEST_CASE("A write outside the table has a line of its own that leads to its sample") {
    Driver driver("one-triangle.toml");
    driver.hand.drag_picture(10, 5, 0, 2);
    driver.hand.drag_picture(5, 10, 3, 1);
    driver.hand.drag_picture(15, 15, 3, 4);
    const RowHistory& rows = driver.ui.results.a.rows;
    REQUIRE(rows.outside.size() == 1);
    CHECK(rows.outside[0].row == 0);
    CHECK(rows.outside[0].y < 1.0f);
    driver.hand.click("rows.outside.0");
    REQUIRE(driver.ui.results.a.rows.last);
    CHECK_FALSE(driver.ui.results.a.rows.last->write.inside);
}

TEST_CASE("A test of another triangle is not shown as one of the chosen triangle") {
    Driver driver("one-triangle.toml");
    Session& session = driver.ui.session;
    set_scene(session, test::pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}},
                                          {{{2, 12, 1}, {4, 12, 1}, {2, 14, 1}}}},
                                         {20, 20}));
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
    session.cursor = *parse_cursor("t0/b4/c6");
    driver.open("rows");
    const auto count_of_tests = [&] {
        const std::vector<ScreenText> all = screen_text();
        return std::count_if(all.begin(), all.end(), [](const ScreenText& text) {
            return text.words.find("pixel (7, 5): inside") != std::string::npos;
        });
    };
    CHECK(count_of_tests() == 1);
    session.selection.triangle = 1;
    driver.hand.leave();
    CHECK(driver.ui.results.a.triangle == 1);
    CHECK(count_of_tests() == 0);
}

TEST_CASE("A dragged bench vertex takes the row table with it") {
    Driver driver("one-triangle.toml");
    driver.hand.drag_picture(15, 15, 12, 18);
    const glm::vec3 moved = driver.ui.session.scene->corner(0, 2).position;
    CHECK(moved.x == 12.0f);
    CHECK(moved.y == 18.0f);
    CHECK(driver.ui.results.a.rows.rows.size() == 14);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.results.a.rows.rows.size() == 11);
}

TEST_CASE("The bench offers its examples") {
    Driver driver("one-triangle.toml");
    const std::vector<BenchExample> examples = driver.ui.session.scene->examples;
    CHECK(examples.size() >= 11);
    for (const BenchExample& example : examples) {
        INFO(example.name);
        driver.hand.click("bench.examples");
        driver.hand.click("bench.example." + example.name);
        for (int v = 0; v < 3; ++v) {
            CHECK(driver.ui.session.scene->corner(0, v).position == example.positions[v]);
        }
    }
}

} // namespace rasterwalk
