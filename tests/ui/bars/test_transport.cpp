#include <catch2/catch.hpp>

#include "session/moment_text.h"
#include "session/walk.h"
#include "tests/ui/driver.h"
#include "ui/actions/keys.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

std::string cursor_text(const Driver& driver) {
    return to_text(driver.ui.results.a.cursor);
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

TEST_CASE("Play takes one step after the other, never two at once, and stops at the end") {
    Driver driver("one-triangle.toml");
    driver.ui.session.play.speed = fastest_play;
    driver.hand.click("walk.play");
    CHECK(driver.ui.session.play.running);
    const Timeline timeline(driver.ui.results.a.frame);
    Cursor before = driver.ui.results.a.cursor;
    int frames = 0;
    while (driver.ui.session.play.running && frames < 1000) {
        driver.hand.frames(1, 0.1f);
        const Cursor now = driver.ui.results.a.cursor;
        INFO("from " << to_text(before) << " to " << to_text(now));
        REQUIRE((now == before || now == timeline.next(before, Granularity::moment)));
        before = now;
        ++frames;
    }
    CHECK(cursor_text(driver) == "end");
    CHECK_FALSE(driver.ui.session.play.running);
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

TEST_CASE("A moment in words names triangle, part, edge and sample, counted from one") {
    Driver driver;
    driver.hand.click("stage.edges");
    CHECK(describe_moment(driver.ui.results.a.frame, {20, Phase::edges, 1, 13}) ==
          "triangles[20] of 30 (tall block) · edge 1 · line[13] of 98");
}

} // namespace rasterwalk
