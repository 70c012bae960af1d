#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "session/moments.h"
#include "session/second_run.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "ui/bars/time_window.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

std::string cursor_text(const Driver& driver) {
    return to_text(driver.ui.results.a.cursor);
}

/// Run B draws without the depth test.
void compare_without_depth(Driver& driver) {
    Settings b = driver.ui.session.a.settings;
    set_from_text(b, "depth_test=off");
    compare_with(driver.ui.session, b);
}

std::string speed_words(const Driver& driver) {
    return driver.ui.widgets.at("walk.speed").text;
}

} // namespace

TEST_CASE("The transport steps through a triangle's vertices and samples, and back") {
    Driver driver("one-triangle.toml");
    driver.hand.click("walk.first");
    CHECK(cursor_text(driver) == "t0/v0");
    for (const char* expected : {"t0/v1", "t0/v2", "t0/e0/s0", "t0/e0/s1"}) {
        driver.hand.click("walk.step");
        CHECK(cursor_text(driver) == expected);
    }
    for (const char* expected : {"t0/e0/s0", "t0/v2", "t0/v1", "t0/v0", "t0/v0"}) {
        driver.hand.click("walk.back");
        CHECK(cursor_text(driver) == expected);
    }
    driver.hand.click("walk.last");
    CHECK(cursor_text(driver) == "end");
}

TEST_CASE("A step is as large as was chosen") {
    Driver driver("one-triangle.toml");
    driver.hand.click("stage.fill");
    driver.hand.press(key::home);
    driver.hand.click("step.line");
    for (const char* expected : {"t0/e0/s0", "t0/e1/s0", "t0/e2/s0", "t0/r0/c0", "t0/r1/c0"}) {
        driver.hand.press(key::period);
        CHECK(cursor_text(driver) == expected);
    }
    driver.hand.click("step.phase");
    driver.hand.press(key::comma);
    CHECK(cursor_text(driver) == "t0/r0/c0");
    driver.hand.press(key::comma);
    CHECK(cursor_text(driver) == "t0/e0/s0");
    driver.hand.click("step.triangle");
    driver.hand.press(key::period);
    CHECK(cursor_text(driver) == "end");
}

TEST_CASE("The brackets go from triangle to triangle whatever the size of a step") {
    Driver driver;
    driver.hand.press(key::home);
    driver.hand.press(key::right_bracket);
    driver.hand.press(key::right_bracket);
    CHECK(cursor_text(driver) == "t2/v0");
    driver.hand.press(key::left_bracket);
    CHECK(cursor_text(driver) == "t1/v0");
}

TEST_CASE("Play takes as many steps as its dial says, several a frame, and stops at the end") {
    Driver driver("one-triangle.toml");
    driver.ui.session.play.speed = {SpeedUnit::steps, 60.0};
    driver.hand.click("walk.play");
    CHECK(driver.ui.session.play.running);
    const Timeline timeline(driver.ui.results.a.frame);
    const Cursor before = driver.ui.results.a.cursor;
    driver.hand.frames(3, 0.1f);
    CHECK(timeline.ordinal(driver.ui.results.a.cursor) == timeline.ordinal(before) + 18);
    driver.hand.frames(5, 0.1f);
    CHECK(cursor_text(driver) == "end");
    CHECK_FALSE(driver.ui.session.play.running);
}

TEST_CASE("The first Play draws the whole picture in 15 seconds from its beginning") {
    Driver driver;
    CHECK(cursor_text(driver) == "end");
    CHECK(speed_words(driver) == "frame in 15 s");
    driver.hand.press(key::space);
    const Timeline timeline(driver.ui.results.a.frame);
    CHECK(timeline.place(driver.ui.results.a.cursor) < 0.02);
    driver.hand.frames(15, 0.5f);
    CHECK(timeline.place(driver.ui.results.a.cursor) == Approx(0.5).margin(0.02));
    CHECK(driver.ui.session.play.running);
    driver.hand.frames(16, 0.5f);
    CHECK(cursor_text(driver) == "end");
    CHECK_FALSE(driver.ui.session.play.running);
}

TEST_CASE("The dial says what the play does in this frame at this size of a step") {
    Driver driver("one-triangle.toml");
    CHECK(speed_words(driver) == "frame in 15 s");
    driver.hand.click("step.triangle");
    driver.hand.leave();
    CHECK(speed_words(driver) == "2 steps/s");
    driver.hand.click("step.moment");
    driver.hand.leave();
    CHECK(speed_words(driver) == "frame in 15 s");
}

TEST_CASE("The dial is dragged, turned by the wheel or the keys, and set back by a double click") {
    Driver driver;
    driver.hand.drag("walk.speed", -1000.0f, 0.0f);
    CHECK(speed_words(driver) == "1 step/s");
    driver.hand.drag("walk.speed", 1000.0f, 0.0f);
    CHECK(speed_words(driver) == "no limit");
    driver.hand.wheel("walk.speed", -1.0f);
    CHECK(speed_words(driver) == "frame in 1 s");
    driver.hand.press(key::minus);
    CHECK(speed_words(driver) == "frame in 2 s");
    driver.hand.press(key::equal);
    driver.hand.press(key::equal);
    CHECK(speed_words(driver) == "no limit");
    driver.hand.double_click("walk.speed");
    CHECK(speed_words(driver) == "frame in 15 s");
}

TEST_CASE("Space pauses the play") {
    Driver driver("one-triangle.toml");
    driver.hand.press(key::space);
    CHECK(driver.ui.session.play.running);
    driver.hand.press(key::space);
    CHECK_FALSE(driver.ui.session.play.running);
}

TEST_CASE("The scrub bar shows the picture at the moment under the pointer") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click("walk.scrub");
    const Cursor cursor = driver.ui.results.a.cursor;
    CHECK(cursor.triangle >= 14);
    CHECK(cursor.triangle <= 15);
    Framebuffer expected;
    clear(expected, driver.ui.session.a.settings.viewport);
    draw(driver.ui.results.a.frame, {cursor_begin, cursor, {}}, expected);
    CHECK(*driver.ui.results.a.framebuffer == expected);
    driver.hand.drag("walk.scrub", -200.0f, 0.0f);
    CHECK(driver.ui.results.a.cursor < cursor);
}

TEST_CASE("The lower time line goes to any moment of the triangle at work, and stays with it") {
    Driver driver;
    driver.hand.click("stage.edges");
    driver.ui.session.cursor = {20, Phase::edges, 1, 13};
    driver.hand.frames(2);
    const Timeline timeline(driver.ui.results.a.frame);
    const TriangleScale scale = triangle_scale(timeline.moments(20));
    driver.hand.click("walk.window");
    const Cursor middle = driver.ui.results.a.cursor;
    CHECK(middle.triangle == 20);
    CHECK(scale.share_of(timeline.ordinal(middle)) == Approx(0.5).margin(0.01));
    driver.hand.drag("walk.window", -2000.0f, 0.0f);
    CHECK(cursor_text(driver) == "t20/v0");
    driver.hand.drag("walk.window", 2000.0f, 0.0f);
    CHECK(cursor_text(driver) == "t21/v0");
    CHECK(driver.ui.transport.window.begin == 20.0);
    driver.hand.press(key::period);
    CHECK(driver.ui.transport.window.begin == 21.0);
}

TEST_CASE("The wheel enlarges what is under the pointer, the bracket is dragged along the frame") {
    Driver driver;
    driver.hand.click("stage.edges");
    driver.ui.session.cursor = {20, Phase::edges, 1, 13};
    driver.hand.frames(2);
    const TimeWindow& window = driver.ui.transport.window;
    CHECK(window.width == 1.0);
    driver.hand.wheel("walk.window", 3.0f);
    CHECK(window.width < 0.5);
    CHECK(window.begin + 0.5 * window.width == Approx(20.5).margin(0.01));
    driver.hand.double_click("walk.window");
    CHECK(window.begin == 20.0);
    CHECK(window.width == 1.0);
    const Cursor before = driver.ui.results.a.cursor;
    driver.hand.drag("walk.bracket", -200.0f, 0.0f);
    CHECK(window.begin < 15.0);
    CHECK(window.begin > 5.0);
    CHECK(driver.ui.results.a.cursor == before);
    driver.hand.wheel("walk.scrub", -40.0f);
    driver.hand.wheel("walk.scrub", -40.0f);
    CHECK(window.width == 30.0);
    CHECK_FALSE(driver.hand.is_visible("walk.bracket"));
}

TEST_CASE("Where two runs differ is marked on the line of the frame, and a click leads there") {
    Driver driver;
    driver.hand.click("stage.depth");
    CHECK_FALSE(driver.hand.is_visible("walk.difference.0"));
    compare_without_depth(driver);
    driver.hand.frames(4);
    const auto& groups = driver.ui.results.comparison.whole().divergences.groups;
    REQUIRE_FALSE(groups.empty());
    const auto& marks = driver.ui.transport.differences.marks;
    REQUIRE_FALSE(marks.empty());
    const WidgetPlace line = driver.ui.widgets.at("walk.scrub");
    const Timeline timeline(driver.ui.results.a.frame);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Cursor first = groups[marks[i].group].first;
        const float width = line.bottom_right.x - line.top_left.x;
        CAPTURE(i, to_text(first));
        CHECK(marks[i].x == Approx(width * timeline.place(first)).margin(1.0));
        driver.hand.click("walk.difference." + std::to_string(i));
        CHECK(to_text(driver.ui.session.cursor) == to_text(first));
    }
    stop_comparing(driver.ui.session);
    driver.hand.frames(2);
    CHECK_FALSE(driver.hand.is_visible("walk.difference.0"));
}

TEST_CASE("Nothing of the transport lies over anything else, in every window and text") {
    struct Window {
        ImVec2 size;
        float text;
    };
    const std::vector<Window> windows{
        {{1600, 1000}, 1.0f}, {{1600, 1000}, 1.5f}, {{1600, 1000}, 2.5f}, {{1280, 720}, 1.0f},
        {{1024, 640}, 1.0f},  {{1024, 640}, 1.5f},  {{800, 600}, 1.0f},   {{800, 600}, 2.0f},
        {{1590, 500}, 1.0f},  {{320, 200}, 1.0f}};
    for (const Window& window : test::some_of(windows, 4)) {
        Driver driver("lab-room.toml", window.size, window.text);
        driver.hand.click("stage.depth");
        compare_without_depth(driver);
        driver.hand.press(key::home);
        driver.hand.frames(4);
        driver.hand.leave();
        std::vector<std::pair<std::string, WidgetPlace>> parts;
        for (const auto& [name, place] : driver.ui.widgets) {
            if (name.starts_with("walk.") || name.starts_with("step.")) {
                parts.emplace_back(name, place);
            }
        }
        CHECK(parts.size() >= 8);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const WidgetPlace &a = parts[i].second, &b = parts[j].second;
                const float across = std::min(a.bottom_right.x, b.bottom_right.x) -
                                     std::max(a.top_left.x, b.top_left.x);
                const float down = std::min(a.bottom_right.y, b.bottom_right.y) -
                                   std::max(a.top_left.y, b.top_left.y);
                CAPTURE(window.size.x, window.text, parts[i].first, parts[j].first, across, down);
                CHECK((across <= 0.5f || down <= 0.5f));
            }
        }
    }
}

TEST_CASE("A moment in words names triangle, part, edge and sample, counted from one") {
    Driver driver;
    driver.hand.click("stage.edges");
    CHECK(describe_moment(driver.ui.results.a.frame, {20, Phase::edges, 1, 13}) ==
          "triangles[20] of 30 (tall block) · edge 1 · line[13] of 98");
}

} // namespace rasterwalk
