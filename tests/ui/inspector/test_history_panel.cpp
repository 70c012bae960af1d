#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "session/results.h"
#include "session/session.h"
#include "stages/depth_test.h"
#include "support/project_root.h"
#include "support/samples.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/lesson_links.h"
#include "ui/inspector/depth_ruler_part.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

glm::vec3 picked_colour(const Driver& driver) {
    const Framebuffer& picture = *driver.ui.results.a.framebuffer;
    const glm::ivec2 pixel = *driver.ui.session.selection.pixel;
    return picture.colour[picture.at(pixel.x, pixel.y)];
}

} // namespace

TEST_CASE("Without a picked pixel the history asks for one, and so do the keys for its changes") {
    Driver driver;
    driver.open("history");
    CHECK(driver.hand.is_visible("history.empty"));
    for (const int key : {'N', 'B'}) {
        driver.ui.session.notice.clear();
        driver.hand.press(key);
        CHECK_THAT(driver.ui.session.notice,
                   Catch::Matchers::ContainsSubstring("No pixel is picked"));
        CHECK(driver.ui.results.a.cursor == cursor_end);
    }
    driver.hand.click_picture(240, 300);
    CHECK_FALSE(driver.hand.is_visible("history.empty"));
    CHECK(driver.hand.is_visible("history.2"));
}

TEST_CASE("A click on a line of the history goes to the moment just after that fragment") {
    Driver driver;
    driver.open("history");
    driver.hand.click_picture(240, 300);
    REQUIRE(driver.ui.results.history);
    const std::vector<PixelEntry> entries = driver.ui.results.history->entries;
    REQUIRE(entries.size() == 3);
    for (const int line : {2, 0, 1}) {
        INFO("line " << line);
        driver.hand.click("history." + std::to_string(line));
        CHECK(driver.ui.results.a.done == entries[line].cursor);
        CHECK(driver.ui.session.selection.triangle == entries[line].cursor.triangle);
        CHECK(picked_colour(driver) == entries[line].colour_after);
        // Fragments still to come keep their lines.
        CHECK(driver.hand.is_visible("history.2"));
    }
    driver.hand.press(key::left, {.alt = true});
    CHECK(driver.ui.results.a.done == entries[0].cursor);
}

TEST_CASE("The keys and the buttons of the transport walk through the changes of the pixel") {
    Driver driver;
    driver.hand.click_picture(240, 300);
    REQUIRE(driver.ui.results.history);
    const std::vector<PixelEntry> entries = driver.ui.results.history->entries;
    driver.hand.press(key::home);
    driver.hand.press('N');
    CHECK(driver.ui.results.a.done == entries[0].cursor);
    driver.hand.click("walk.next_change");
    CHECK(driver.ui.results.a.done == entries[1].cursor);
    CHECK(driver.ui.session.notice.empty());
    driver.hand.press('N');
    CHECK(driver.ui.results.a.done == entries[1].cursor);
    CHECK(driver.ui.session.notice == "Pixel (240, 300) has no later change.");
    driver.hand.click("walk.previous_change");
    CHECK(driver.ui.results.a.done == entries[0].cursor);
    CHECK(driver.ui.session.notice.empty());
    driver.hand.press('B');
    CHECK(driver.ui.session.notice == "Pixel (240, 300) has no earlier change.");
}

TEST_CASE("An uncovered pixel says which triangle comes nearest, and lets its remedy be tried") {
    Driver driver;
    driver.open("history");
    driver.hand.click_picture(0, 250);
    REQUIRE(driver.ui.results.history);
    REQUIRE(driver.ui.results.history->entries.empty());
    driver.hand.click("history.near.0");
    CHECK(driver.ui.session.selection.triangle == 2);
    driver.hand.click("history.try.rounding=floor");
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::floor);
    REQUIRE(driver.ui.results.history);
    REQUIRE(driver.ui.results.history->entries.size() == 1);
    CHECK(driver.ui.results.history->entries[0].cursor.triangle == 2);
    CHECK(driver.hand.is_visible("history.0"));
    driver.hand.press('Z', {.ctrl = true});
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::truncate);
    CHECK(driver.hand.is_visible("history.near.0"));
}

TEST_CASE("The history follows the stage: marks have their lines too") {
    Driver driver;
    driver.open("history");
    driver.hand.click_picture(126, 126);
    driver.hand.click("stage.edges");
    REQUIRE(driver.ui.results.history);
    CHECK(driver.ui.results.history->entries.size() == 10);
    driver.hand.click("history.4");
    CHECK(driver.ui.results.a.done == driver.ui.results.history->entries[4].cursor);
    driver.hand.click("stage.points");
    CHECK(driver.ui.results.history->entries.size() == 5);
    CHECK(driver.hand.is_visible("history.0"));
}

TEST_CASE("Without a picked pixel the history offers two to begin with") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.open("history");
    const Framebuffer& picture = *driver.ui.results.a.framebuffer;
    driver.hand.click("history.pick_most");
    REQUIRE(driver.ui.session.selection.pixel);
    const glm::ivec2 pixel = *driver.ui.session.selection.pixel;
    CHECK(picture.overdraw[picture.at(pixel.x, pixel.y)] ==
          *std::max_element(picture.overdraw.begin(), picture.overdraw.end()));
    CHECK(driver.hand.is_visible("history.0"));

    driver.ui.session.selection = {};
    driver.ui.session.cursor = *parse_cursor("t22/r40/c5");
    driver.hand.rest();
    driver.hand.click("history.pick_last");
    REQUIRE(driver.ui.results.history);
    const std::vector<PixelEntry>& entries = driver.ui.results.history->entries;
    CHECK(std::any_of(entries.begin(), entries.end(), [&](const PixelEntry& entry) {
        return entry.cursor == *driver.ui.results.a.done;
    }));
}

TEST_CASE("Before anything is drawn there is no pixel to begin with, and it says so") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click("walk.first");
    driver.open("history");
    CHECK_FALSE(driver.hand.is_visible("history.pick_last"));
    driver.hand.click("history.pick_most");
    CHECK_FALSE(driver.ui.session.selection.pixel);
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring("Nothing has been drawn"));
}

TEST_CASE("The place of a fragment is below the names of what it counts") {
    struct Case {
        const char* stage;
        const char* piece;
        const char* step; ///< empty: there is no such column
    };
    for (const Case& c : {Case{"points", "vertex", ""}, Case{"edges", "edge", "line"},
                          Case{"rows", "entry", "fragment"}, Case{"fill", "entry", "fragment"}}) {
        Driver driver("one-triangle.toml");
        driver.hand.click(std::string("stage.") + c.stage);
        driver.open("history");
        driver.hand.click_picture(5, 10);
        driver.hand.leave();
        INFO(c.stage << ", tab " << driver.ui.session.tab);
        REQUIRE(driver.ui.results.history);
        REQUIRE_FALSE(driver.ui.results.history->entries.empty());
        const auto stands = [](const std::string& words) {
            const std::vector<ScreenText> texts = screen_text();
            return std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
                return text.window.find("history") != text.window.npos && text.words == words;
            });
        };
        CHECK(stands(c.piece));
        if (*c.step != 0) CHECK(stands(c.step));
        CHECK(driver.hand.is_visible("history.header.step") == (*c.step != 0));
        CHECK_FALSE(stands("row [column]"));
    }
}

TEST_CASE("Every line names its triangle, however many there are and however little room") {
    std::vector<std::array<glm::vec3, 3>> triangles(110'000,
                                                    {{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}});
    for (int i = 0; i < 4; ++i)
        triangles.push_back({{{2, 2, 1}, {30, 2, 1}, {2, 30, 1}}});
    Session session = open_session(project_root() + "/lessons/scenes/lab-room.toml");
    set_scene(session, test::pixel_scene(triangles, {40, 40}));
    for (const ImVec2 window : {ImVec2(640, 480), ImVec2(800, 600), ImVec2(1600, 1000)}) {
        CAPTURE(window.x, window.y);
        Driver driver(session, window);
        driver.ui.session.selection.pixel = glm::ivec2(5, 5);
        driver.open("history");
        driver.hand.leave();
        REQUIRE(driver.ui.results.history);
        REQUIRE(driver.ui.results.history->entries.size() == 4);
        std::string words;
        bool has_header = false;
        for (const ScreenText& text : screen_text()) {
            if (!text.window.starts_with("inspector")) continue;
            words += text.words + "\n";
            has_header = has_header || text.words == "triangle";
        }
        CHECK(has_header);
        for (const char* name : {"t110000", "t110001"})
            CHECK_THAT(words, Catch::Matchers::ContainsSubstring(name));
    }
}

TEST_CASE("The ruler says how far apart two depths are that the buffer can tell apart") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.open("history");
    driver.hand.click_picture(240, 300);
    driver.hand.rest();
    const std::vector<std::string> widgets{"history.ruler", "history.ruler.window",
                                           "history.ruler.gap"};
    // Floats of 1/z are fine enough here.
    for (const std::string& name : widgets)
        CHECK(driver.ui.widgets.count(name) == 0);
    const auto words = [&] {
        std::string all;
        for (const ScreenText& text : screen_text())
            if (text.window.starts_with("inspector")) all += text.words + " ";
        return all;
    };
    // In 16 bits, 1/z at most 1/near: a step is 1/near / 65535, in z that times z squared.
    follow_link(driver.ui, "set:depth_format=inv_z_16");
    driver.hand.rest();
    for (const std::string& name : widgets)
        CHECK(driver.ui.widgets.count(name) == 1);
    REQUIRE(driver.ui.results.history);
    const PixelHistory& history = *driver.ui.results.history;
    const double stored =
        static_cast<double>(history.entries[static_cast<std::size_t>(history.winner)].depth);
    const double near = static_cast<double>(driver.ui.session.a.settings.near);
    const double step = 1.0 / near / 65535.0;
    const auto three = [](double value) { return significant(value, 3); };
    const std::string nearer = three(1.0 / stored - 1.0 / (stored + step));
    const std::string farther = three(1.0 / (stored - step) - 1.0 / stored);
    const std::string sentence = "can hold are " + nearer + " nearer and " + farther + " farther";
    CHECK_THAT(words(), Catch::Matchers::ContainsSubstring(sentence));
    // Without a test there is nothing to tell apart.
    follow_link(driver.ui, "set:depth_test=off");
    driver.hand.rest();
    for (const std::string& name : widgets)
        CHECK(driver.ui.widgets.count(name) == 0);
}

TEST_CASE("The ruler has a mark for the fragment shown, however many came before it") {
    PixelHistory history;
    for (int i = 0; i < 100; ++i) {
        PixelEntry entry;
        entry.cursor = {i, Phase::rows, 0, 0};
        entry.z = 1.0f + static_cast<float>(i);
        entry.depth = 1.0f / entry.z;
        history.entries.push_back(entry);
    }
    history.winner = 80;
    const auto check = [&](const Cursor* shown, const std::string& name) {
        INFO(name);
        const HistoryMarks found = marks_of_history(history, shown, DepthRules{});
        CHECK(found.marks.size() == most_depth_marks);
        REQUIRE(found.chosen < found.marks.size());
        CHECK(found.marks[found.chosen].name == name);
    };
    for (const int shown : {0, 63, 64, 99}) {
        const Cursor& cursor = history.entries[static_cast<std::size_t>(shown)].cursor;
        check(&cursor, "t" + std::to_string(shown));
    }
    check(nullptr, "t80"); // the one that stays
}

} // namespace rasterwalk
