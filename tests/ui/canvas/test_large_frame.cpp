#include "ui/canvas/large_frame.h"

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/many_walls.h"
#include "ui/actions/lesson_links.h"
#include "ui/app/app.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

std::string large_frame_text(const Driver& driver) {
    const auto place = driver.ui.widgets.find("canvas.fragments");
    return place != driver.ui.widgets.end() ? place->second.text : std::string();
}

bool has(const Driver& driver, const char* name) {
    return driver.ui.widgets.contains(name);
}

} // namespace

TEST_CASE("Fragments outside the picture are reported, and a click clips them") {
    Driver driver;
    driver.hand.frames(2);
    CHECK(large_frame_text(driver).empty());
    follow_link(driver.ui, "set:camera.position=0,0,-1.05");
    driver.hand.frames(2);
    CHECK(large_frame_text(driver).starts_with(
        "About 402 million fragments, 99.9 % outside the picture"));
    // They are not drawn, so there is nothing to wait for.
    CHECK(driver.ui.results.a.is_drawn());
    CHECK_FALSE(has(driver, "canvas.draw_it"));
    CHECK_FALSE(has(driver, "canvas.stop"));
    driver.hand.click("canvas.clip_it");
    driver.hand.frames(2);
    CHECK(driver.ui.session.a.settings.clip == Clip::all);
    CHECK(large_frame_text(driver).empty());
    CHECK(driver.ui.results.a.is_drawn());
}

TEST_CASE("A frame of very many fragments in the picture waits, is drawn in parts, and stops") {
    Driver driver(session_of(many_walls()));
    driver.hand.frames(3);
    const RunResults& run = driver.ui.results.a;
    CHECK(large_frame_text(driver).starts_with("About 60 million fragments: not drawn yet"));
    CHECK(run.is_deferred);
    CHECK(run.replay.drawn() == cursor_begin);
    CHECK_FALSE(is_working(driver.ui.results));
    CHECK_FALSE(is_animating(driver.ui)); // nothing to do until it is requested

    driver.hand.click("canvas.draw_it");
    const double begun = run.replay.work().before(run.replay.drawn());
    driver.hand.frames(1);
    const double later = run.replay.work().before(run.replay.drawn());
    CHECK(later > begun);
    CHECK(later - begun < 2.0 * frame_limit.at_once);
    CHECK(is_working(driver.ui.results));

    driver.hand.click("canvas.stop");
    const Cursor stopped = run.replay.drawn();
    CHECK_FALSE(run.is_drawn());
    driver.hand.frames(3);
    CHECK(run.replay.drawn() == stopped);
    CHECK(large_frame_text(driver).find("stopped") != std::string::npos);
    CHECK_FALSE(is_animating(driver.ui));

    // A different frame has to be requested again.
    driver.hand.click("canvas.draw_it");
    CHECK_FALSE(run.is_deferred);
    driver.ui.session.a.settings.camera.position.z = -0.001f;
    driver.hand.frames(1);
    while (run.preview.is_shown)
        driver.hand.frames(1);
    CHECK(run.is_deferred);
    CHECK(run.replay.drawn() == cursor_begin);
}

} // namespace rasterwalk
