// The Speed tab, driven by clicks. How long anything takes is never checked.

#include <cmath>
#include <string>
#include <vector>

#include "engines/ladder/ladder.h"
#include "tests/support/catch.h"
#include "tests/ui/made_ladder.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/measure.h"
#include "ui/app/app.h"
#include "ui/inspector/speed_parts.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

using Catch::Matchers::ContainsSubstring;

namespace {

std::string widget_of(std::size_t index) {
    const std::size_t count = ladder().size();
    return index < count ? "speed.rung." + std::to_string(index)
                         : "speed.turning." + std::to_string(index - count);
}

/// A small room with light, at the Speed tab.
void open_small(Driver& driver) {
    follow_link(driver.ui, "set:viewport.size=80x80&camera.focal_length=80&stage=pixel_light");
    driver.hand.rest();
    driver.ui.ladder.rounds = 2;
    driver.open("speed");
    driver.hand.leave();
}

/// Frames until nothing is measured any more.
void wait_for_times(Driver& driver) {
    while (is_measuring(driver.ui))
        driver.hand.frames(1);
    driver.hand.rest();
}

bool has_widget(const Driver& driver, const std::string& name) {
    return driver.ui.widgets.count(name) > 0;
}

/// Is anything shown as measured?
bool shows_times(Driver& driver) {
    for (std::size_t i = 0; i < rung_count(); ++i) {
        if (!shown_text(driver, widget_of(i)).empty()) return true;
    }
    return has_widget(driver, "speed.scale") || has_widget(driver, "speed.rounds") ||
           has_widget(driver, "speed.all") || has_widget(driver, "speed.foot") ||
           shows_words(" ms", "inspector");
}

} // namespace

TEST_CASE("Before it is measured, the ladder is a list of changes without any time") {
    Driver driver;
    open_small(driver);
    CHECK(shown_text(driver, "speed.status").starts_with("Not measured on this machine yet."));
    CHECK_FALSE(shows_times(driver));
    CHECK_FALSE(is_measuring(driver.ui));
    for (std::size_t i = 0; i < rung_count(); ++i) {
        driver.hand.click(widget_of(i));
        CHECK(shown_text(driver, "speed.change") == rung_at(i).change);
        CHECK(shown_text(driver, "speed.why") == rung_at(i).why);
        CHECK(driver.ui.ladder.chosen == i);
    }
}

TEST_CASE("Measuring gives every rung a time and what it gained, by a thread or by the frames") {
    for (const StepMaker maker : {StepMaker::thread, StepMaker::advance}) {
        Driver driver;
        open_small(driver);
        driver.ui.ladder.maker = maker;
        driver.hand.click("speed.measure");
        wait_for_times(driver);
        const std::vector<RungTime>& times = driver.ui.ladder.times.rungs;
        REQUIRE(times.size() == rung_count());
        CHECK(driver.ui.ladder.times.rounds == 2);
        for (std::size_t i = 0; i < rung_count(); ++i) {
            CAPTURE(i);
            const std::string shown = shown_text(driver, widget_of(i));
            CHECK(std::abs(number_in(shown) - times[i].median) <=
                  0.006 * std::max(times[i].median, 1.0));
            CHECK((shown.find("×") != std::string::npos || shown.find("÷") != std::string::npos) ==
                  (i > 0));
        }
        CHECK(shown_text(driver, "speed.status") ==
              "Bars show what each rung gained, by the median of 2 rounds.");
        CHECK(has_widget(driver, "speed.all"));
        driver.hand.click(widget_of(0));
        CHECK(shown_text(driver, "speed.median").starts_with("2 rounds: median "));
        CHECK(has_widget(driver, "speed.measure"));
    }
}

TEST_CASE("The gain of a rung is the quotient of two times, and what is slower is divided") {
    Driver driver;
    open_small(driver);
    show_made_times(driver);
    driver.hand.rest();
    CHECK(shown_text(driver, "speed.rung.0") == "64.0 ms");
    CHECK(shown_text(driver, "speed.rung.1") == "32.0 ms, × 2.0");
    const double all = std::pow(2.0, static_cast<double>(ladder().size() - 1));
    CHECK(number_in(shown_text(driver, "speed.all").substr(std::string("× ").size())) == all);
    driver.ui.ladder.times.rungs[1].median = 640.0;
    driver.hand.rest();
    CHECK(shown_text(driver, "speed.rung.1") == "640 ms, ÷ 10");
    // Half of one round is slower: the quartiles of 64, 64 and 128.
    driver.hand.click("speed.rung.0");
    CHECK(shown_text(driver, "speed.median") ==
          "3 rounds: median 64.0 ms, middle half 64.0 ms to 96.0 ms");
}

TEST_CASE("Measuring stops by its button and by Esc, and keeps only times of every rung") {
    Driver driver;
    open_small(driver);
    driver.ui.ladder.maker = StepMaker::advance;
    const auto pictures = static_cast<int>(rung_count());
    for (const bool by_key : {false, true}) {
        for (const bool is_early : {true, false}) {
            CAPTURE(by_key, is_early);
            driver.ui.ladder.rounds = 1000;
            driver.hand.click("speed.measure");
            REQUIRE(is_measuring(driver.ui));
            CHECK(has_widget(driver, "speed.progress"));
            if (!is_early) driver.hand.frames(3 * pictures + 1);
            if (by_key) {
                driver.ui.focus.is_shown = false;
                driver.hand.press(key::escape);
            } else {
                driver.hand.click("speed.stop");
            }
            driver.hand.rest();
            CHECK_FALSE(is_measuring(driver.ui));
            CHECK(driver.ui.ladder.stopped.empty());
            CHECK_FALSE(has_widget(driver, "speed.progress"));
            CHECK(shows_times(driver) == driver.ui.ladder.times.has_all());
            if (!is_early) CHECK(driver.ui.ladder.times.rounds >= 2);
        }
    }
}

TEST_CASE("Rounds are counted once all pictures are compared") {
    Driver driver;
    open_small(driver);
    driver.ui.ladder.maker = StepMaker::advance;
    driver.ui.ladder.rounds = 1000;
    driver.hand.click("speed.measure");
    REQUIRE(is_measuring(driver.ui));
    const auto status = [&] { return driver.ui.widgets.at("speed.status").text; };
    const auto pictures = [&] {
        return std::lround(driver.ui.ladder.times.share * 1001.0f *
                           static_cast<float>(rung_count()));
    };
    int comparing = 0;
    for (; pictures() < static_cast<long>(rung_count()); ++comparing) {
        CHECK(status() == "Comparing the pictures …");
        driver.hand.frames(1);
    }
    CHECK(comparing > 1);
    CHECK(status() == "Round 1 of 1000");
    driver.hand.click("speed.stop");
}

TEST_CASE("The foot names the processor, if the system does, and how time is taken") {
    Driver driver;
    open_small(driver);
    show_made_times(driver);
    driver.hand.rest();
    CHECK(shown_text(driver, "speed.foot") == driver.ui.ladder.processor);
    CHECK_THAT(words_in("inspector"), ContainsSubstring("Measured on a made processor"));
    driver.ui.ladder.processor.clear();
    driver.hand.find("speed.foot");
    driver.hand.rest();
    CHECK_THAT(words_in("inspector"), ContainsSubstring("Measured on this machine."));
}

TEST_CASE("Times are dropped when scene, size or camera change, also while they are measured") {
    for (const char* const change :
         {"set:viewport.size=81x80", "set:camera.position=0,0,-2.1", "set:shading=gouraud"}) {
        CAPTURE(change);
        Driver driver;
        open_small(driver);
        show_made_times(driver);
        driver.hand.rest();
        REQUIRE(shows_times(driver));
        follow_link(driver.ui, "set:engine=fast");
        driver.hand.rest();
        CHECK(shows_times(driver));
        follow_link(driver.ui, change);
        driver.hand.frames(1);
        CHECK_FALSE(shows_times(driver));
        driver.ui.ladder.rounds = 1000;
        driver.hand.click("speed.measure");
        REQUIRE(is_measuring(driver.ui));
        follow_link(driver.ui, "set:viewport.size=70x70");
        driver.hand.frames(2);
        CHECK_FALSE(is_measuring(driver.ui));
        CHECK_FALSE(shows_times(driver));
    }
    Driver driver;
    open_small(driver);
    show_made_times(driver);
    show_scene(driver.ui.session, std::make_shared<const Scene>(*driver.ui.session.scene));
    driver.hand.rest();
    CHECK_FALSE(shows_times(driver));
}

TEST_CASE("What the ladder cannot draw is named, and light is one click away") {
    Driver driver;
    open_small(driver);
    follow_link(driver.ui, "set:stage=depth");
    driver.hand.rest();
    CHECK_FALSE(has_widget(driver, "speed.measure"));
    CHECK_THAT(shown_text(driver, "speed.obstacle"), ContainsSubstring("It cannot be measured: "));
    measure_ladder(driver.ui);
    CHECK_FALSE(is_measuring(driver.ui));
    driver.hand.click("speed.light");
    driver.hand.rest();
    CHECK(driver.ui.session.a.settings.stage == Stage::shade);
    CHECK(has_widget(driver, "speed.measure"));
    follow_link(driver.ui, "set:camera.yaw=0.3");
    driver.hand.rest();
    CHECK_FALSE(has_widget(driver, "speed.measure"));
    CHECK_FALSE(has_widget(driver, "speed.light"));
}

TEST_CASE("The race shows the wrong pixels of each of its pictures") {
    Driver driver;
    open_small(driver);
    std::size_t racing = 0;
    while (!rung_at(racing).is_random)
        ++racing;
    driver.hand.click("speed.rung.0");
    CHECK_FALSE(has_widget(driver, "speed.race"));
    driver.hand.click(widget_of(racing));
    if (ladder_threads() == 1) {
        CHECK(has_widget(driver, "speed.no_race"));
        return;
    }
    CHECK_FALSE(has_widget(driver, "speed.race.runs"));
    driver.hand.click("speed.race");
    while (is_racing(driver.ui))
        driver.hand.frames(1);
    driver.hand.rest();
    REQUIRE(driver.ui.ladder.wrong.size() == usual_race_runs);
    std::string counts;
    for (const std::int64_t wrong : driver.ui.ladder.wrong)
        counts += (counts.empty() ? "" : " · ") + grouped(wrong);
    CHECK(shown_text(driver, "speed.race.runs") == counts);
}

TEST_CASE("The last rung is compared with the steps") {
    Driver driver;
    open_small(driver);
    driver.hand.click(widget_of(ladder().size() - 1));
    driver.hand.click("speed.compare");
    driver.hand.rest();
    REQUIRE(driver.ui.session.b);
    CHECK(driver.ui.session.a.settings.engine == Engine::steps);
    CHECK(driver.ui.session.b->settings.engine == Engine::fast);
    CHECK(driver.ui.session.tab == "compare");
}

TEST_CASE("Only what needs frames to be measured is drawn without a pause") {
    Driver driver;
    open_small(driver);
    driver.hand.rest();
    REQUIRE_FALSE(is_animating(driver.ui));
    CHECK(std::isinf(seconds_to_progress(driver.ui)));
    driver.ui.ladder.rounds = 1000;
    driver.hand.click("speed.measure");
    driver.hand.leave();
    CHECK_FALSE(is_animating(driver.ui));
    const double pause = seconds_to_progress(driver.ui);
    CHECK(pause > 0.0);
    CHECK(pause < 1.0);
    driver.hand.click("speed.stop");
    driver.ui.ladder.maker = StepMaker::advance;
    driver.hand.click("speed.measure");
    CHECK(is_animating(driver.ui));
    driver.hand.click("speed.stop");
    CHECK_FALSE(is_measuring(driver.ui));
}

TEST_CASE("The menu measures and stops, and keys choose a rung") {
    Driver driver;
    open_small(driver);
    driver.open("vertices");
    driver.ui.ladder.rounds = 1000;
    const Action& action = find_action("speed.measure");
    action.run(driver.ui);
    driver.hand.rest();
    CHECK(driver.ui.session.tab == "speed");
    CHECK(is_measuring(driver.ui));
    CHECK(action.is_on(driver.ui));
    action.run(driver.ui);
    driver.hand.rest();
    CHECK_FALSE(is_measuring(driver.ui));
    REQUIRE(driver.tab_to("speed.rung.1"));
    driver.hand.press(key::enter);
    driver.hand.rest();
    CHECK(driver.ui.ladder.chosen == 1);
}

TEST_CASE("In no window is a text of the Speed tab cut or shortened, with times or without") {
    for (const SmallWindow& window : all_windows()) {
        CAPTURE(window.size.x, window.size.y, window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        open_small(driver);
        for (const bool has_times : {false, true}) {
            if (has_times) show_made_times(driver);
            for (std::size_t i = 0; i < rung_count(); ++i) {
                driver.hand.click(widget_of(i));
                driver.hand.leave();
                for (const ScreenText& text : screen_text()) {
                    if (!text.window.starts_with("inspector")) continue;
                    CAPTURE(text.words);
                    CHECK_FALSE(text.is_cut);
                    CHECK(text.words.find("…") == std::string::npos);
                }
            }
        }
    }
}

} // namespace rasterwalk
