// The Inside tab: a pixel that edge functions test, in numbers.

#include <algorithm>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "support/samples.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// The triangle of the sketch, 13 by 10 pixels; in the moment behind the test of (7, 5).
void show_tested(Driver& driver) {
    Session& session = driver.ui.session;
    set_scene(session, test::pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
    session.cursor = *parse_cursor("t0/b4/c6");
    driver.open("rows");
    driver.hand.leave();
}

/// All words of a part of the window.
std::string words_of_part(const std::string& window) {
    std::string all;
    for (const ScreenText& text : screen_text()) {
        if (text.window.find(window) != text.window.npos) all += text.words + "\n";
    }
    return all;
}

} // namespace

TEST_CASE("The tab of the rows is called Inside where edge functions test pixels") {
    Driver driver("one-triangle.toml");
    driver.open("rows");
    CHECK(shown_text(driver, "tab.rows") == "Rows");
    CHECK(words_of_part("inspector").find("left by") != std::string::npos);
    driver.ui.session.a.settings.coverage = Coverage::edge_functions;
    driver.hand.leave();
    CHECK(shown_text(driver, "tab.rows") == "Inside");
    // Before stage Rows the edges are walked, however pixels are found later.
    driver.hand.click("stage.edges");
    CHECK(shown_text(driver, "tab.rows") == "Rows");
    driver.hand.click("stage.fill");
    driver.ui.session.a.settings.coverage = Coverage::scan_conversion;
    driver.hand.leave();
    CHECK(shown_text(driver, "tab.rows") == "Rows");
}

TEST_CASE("Who wrote an end is not asked where no samples write them") {
    Driver driver("one-triangle.toml");
    driver.open("rows");
    for (const Coverage coverage :
         {Coverage::edge_functions, Coverage::scan_conversion, Coverage::active_edges}) {
        driver.ui.session.a.settings.coverage = coverage;
        driver.hand.leave();
        CAPTURE(std::string(word_of(coverage)));
        CHECK(driver.hand.is_visible("rows.header.count"));
        CHECK_FALSE(driver.hand.is_visible("rows.header.left by"));
        CHECK_FALSE(driver.hand.is_visible("rows.header.right by"));
        CHECK(words_of_part("inspector").find("outside") == std::string::npos);
    }
}

TEST_CASE("The row of the tested pixel is marked, and the time line counts rows of the box") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    const ImU32 white = packed(colour_of(Meaning::current, Theme::dark));
    CHECK(shown_colours(driver.hand.find("rows.5")).count(white) > 0);
    CHECK(shown_colours(driver.hand.find("rows.2")).count(white) == 0);
    CHECK(words_of_part("transport").find("tests · 10 rows") != std::string::npos);
}

TEST_CASE("Each number of a tested pixel says how it came to be when it is clicked") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    CHECK(words_of_part("inspector").find("pixel (7, 5): inside") != std::string::npos);
    CHECK_FALSE(driver.hand.is_visible("inside.formula.expression"));
    // By hand: edge 1 goes from (14.5, 1.5) to (5.5, 10.5), and the centre is (7.5, 5.5).
    driver.hand.click("inside.e.1");
    CHECK(driver.hand.is_visible("inside.formula.expression"));
    CHECK(words_of_part("inspector").find("= −9 · (5.5 − 1.5) − 9 · (7.5 − 14.5)") !=
          std::string::npos);
    CAPTURE(words_of_part("inspector"));
    CHECK(words_of_part("inspector").find("= −36 − (−63)") != std::string::npos);
    driver.hand.click("inside.weight.0");
    CHECK(words_of_part("inspector").find("= 27 / 108") != std::string::npos);
    // Its number leads on to the edge's, and a click on that closes it.
    driver.hand.click("inside.formula.E1");
    CHECK(driver.ui.inspector.chosen.test_number == "e.1");
    driver.hand.click("inside.e.1");
    CHECK_FALSE(driver.hand.is_visible("inside.formula.expression"));
    driver.hand.click("inside.area");
    CHECK(words_of_part("inspector").find("= 48 + 27 + 33") != std::string::npos);
    const std::string all = words_of_part("inspector");
    for (const char* const word : {"v0", "v1", "v2", "0.2500", "0.3056", "0.4444", "1.0000", "108"})
        CHECK(all.find(word) != std::string::npos);
}

TEST_CASE("A picked pixel is explained once it has been tested") {
    Driver driver("one-triangle.toml");
    show_tested(driver);
    const auto has = [&](const char* words) {
        driver.hand.leave();
        return words_of_part("inspector").find(words) != std::string::npos;
    };
    Session& session = driver.ui.session;
    session.selection.pixel = glm::ivec2(13, 8);
    CHECK(has("pixel (7, 5): inside")); // the moment's comes first
    session.cursor = *parse_cursor("t0/v2");
    CHECK_FALSE(has("pixel (13, 8)"));
    session.cursor = cursor_end;
    CHECK(has("pixel (13, 8): outside"));
    session.selection.pixel = glm::ivec2(19, 15); // beside the box
    CHECK_FALSE(has("pixel (19, 15)"));
}

TEST_CASE("Nothing of a tested pixel is cut off at the side") {
    for (const auto& [window, scale] : {std::pair{ImVec2{1600, 1000}, 1.0f},
                                        {ImVec2{1600, 1000}, 1.5f},
                                        {ImVec2{1024, 640}, 1.0f},
                                        {ImVec2{1024, 640}, 1.5f}}) {
        Driver driver("one-triangle.toml", window, scale);
        show_tested(driver);
        for (const char* const name :
             {"inside.e.0", "inside.e.1", "inside.e.2", "inside.area", "inside.weight.0",
              "inside.weight.1", "inside.weight.2", "rows.5.right"}) {
            INFO(name << " at " << window.x << " x " << window.y << ", text " << scale);
            CHECK(driver.hand.find(name).is_whole);
        }
        driver.hand.find("inside.weight.2");
        const std::string all = words_of_part("inspector");
        CAPTURE(all);
        CHECK(all.find("1.0000") != std::string::npos); // on one line
    }
}

} // namespace rasterwalk
