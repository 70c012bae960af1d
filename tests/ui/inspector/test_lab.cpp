#include <cstdlib>

#include "laboratory/quiz.h"
#include "opening/opened_view.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/lit_room.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("A mistake is turned on and compared with the correct run at once, and turned off") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.B9");
    CHECK(driver.ui.lab.chosen == "B9");
    driver.hand.click("lab.on");
    CHECK(is_on(driver.ui.session, "B9"));
    REQUIRE(driver.ui.results.b);
    CHECK(driver.ui.results.comparison.whole().pixels.different > 0);
    driver.hand.click("lab.B3");
    driver.hand.click("lab.on");
    CHECK(is_on(driver.ui.session, "B3"));
    CHECK_FALSE(is_on(driver.ui.session, "B9"));
    driver.hand.click("lab.off");
    CHECK_FALSE(driver.ui.session.b);
    CHECK(driver.ui.session.a.settings == before);
}

TEST_CASE("A mistake that the lab makes itself is said to be on, and compared with the cure") {
    Driver driver;
    driver.open("lab");
    for (const Bug& bug : lab_bugs(driver.ui)) {
        // Judged by the data alone: everything that the mistake sets is as in the lab.
        const Settings lab = default_settings(*driver.ui.session.scene);
        Settings set = lab;
        for (const auto& [name, value] : bug.set) {
            if (name != "stage") set_value(set, *find_setting(name), value);
        }
        const bool is_lab = set == lab;
        INFO(bug.id);
        driver.hand.find("lab." + bug.id);
        CHECK(shown_text(driver, "lab." + bug.id) == (is_lab ? "as it is" : ""));
    }
    for (const char* id : {"B1", "B2", "B19"}) {
        INFO(id);
        driver.hand.click(std::string("lab.") + id);
        driver.hand.find("lab.on");
        CHECK(driver.hand.is_visible("lab.made"));
        driver.hand.click("lab.on");
        CHECK(is_on(driver.ui.session, id));
        driver.hand.leave();
        CHECK_FALSE(driver.hand.is_visible("lab.made"));
        CHECK(shown_text(driver, std::string("lab.") + id) == "on");
        driver.hand.click("lab.off");
    }
    driver.hand.click("lab.B9");
    driver.hand.leave();
    CHECK_FALSE(driver.hand.is_visible("lab.made"));
}

TEST_CASE("Every mistake is described and shows on its own scene, with a way back") {
    Driver driver(lit_room(200));
    const std::shared_ptr<const Scene> room = driver.ui.session.scene;
    driver.open("lab");
    const std::vector<Bug> bugs = lab_bugs(driver.ui);
    REQUIRE(bugs.size() > 25);
    for (const Bug& bug : test::some_of(bugs, 5)) {
        INFO(bug.id);
        driver.hand.click("lab." + bug.id);
        driver.hand.click("lab.scene");
        CHECK(is_on(driver.ui.session, bug.id));
        CHECK(driver.ui.session.notice == "");
        driver.hand.click("lab.off");
        CHECK(driver.ui.session.scene == room);
    }
}

TEST_CASE("A quiz is won by hint, wrong guess and right guess, and all is as before") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.ui.lab.seed = 7;
    driver.hand.click("lab.quiz.start");
    REQUIRE(driver.ui.session.quiz);
    const std::vector<std::string> right = driver.ui.session.quiz->questions[0].bugs;
    // Nothing gives it away.
    driver.hand.click("tab.settings");
    CHECK(driver.hand.is_visible("settings.hidden"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
    const Settings hidden = driver.ui.session.a.settings;
    driver.hand.click("switch.perspective");
    CHECK(driver.ui.session.a.settings == hidden);
    driver.open("lab");
    driver.hand.click("lab.quiz.compare");
    REQUIRE(driver.ui.results.b);
    CHECK(driver.ui.results.comparison.pixels.different > 0);
    driver.hand.click("compare.run_b");
    CHECK(shown_text(driver, "compare.title_b") == "the correct run");
    driver.hand.click("lab.hint");
    CHECK(driver.ui.session.quiz->questions[0].hints == 1);
    const auto choose = [&](const std::string& id) {
        driver.hand.click("lab.choice." + id);
        driver.hand.click("lab.guess");
    };
    for (const Bug& bug : lab_bugs(driver.ui)) {
        if (std::find(right.begin(), right.end(), bug.id) != right.end()) continue;
        choose(bug.id);
        break;
    }
    CHECK_FALSE(is_over(*driver.ui.session.quiz));
    choose(right.front());
    CHECK(is_solved(*driver.ui.session.quiz));
    CHECK(driver.hand.is_visible("lab.verdict"));
    driver.hand.click("lab.quiz.end");
    CHECK_FALSE(driver.ui.session.quiz);
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.ui.options.score.rounds == 1);
    CHECK(driver.ui.options.score.points ==
          points_of_question - cost_of_hint - cost_of_wrong_guess);
}

TEST_CASE("Each mistake names a lesson that there is") {
    Driver driver;
    for (const Bug& bug : lab_bugs(driver.ui)) {
        INFO(bug.id << ": " << bug.lesson);
        CHECK(driver.ui.lesson.lessons.find(bug.lesson) != nullptr);
    }
}

TEST_CASE("All choices of a quiz are shown before it begins") {
    Driver driver;
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.hand.leave();
    const float begin = driver.hand.find("lab.quiz.start").top_left.y;
    for (const char* choice : {"lab.two", "lab.seed", "lab.keep_score"}) {
        INFO(choice);
        CHECK(driver.hand.find(choice).bottom_right.y <= begin);
    }
}

TEST_CASE("While a quiz hides the settings nothing can set them, and nothing gives them away") {
    Driver driver(lit_room(200));
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.hand.enter("lab.seed", "7");
    driver.hand.click("lab.quiz.start");
    const Settings hidden = driver.ui.session.a.settings;
    driver.hand.click("lab.quiz.compare");
    REQUIRE(driver.ui.session.b);
    driver.hand.click("compare.swap");
    driver.open("compare");
    CHECK_FALSE(driver.hand.is_visible("compare.tab.exact"));
    driver.hand.press('P');
    driver.hand.press('Z');
    follow_link(driver.ui, "set:interpolation=affine");
    follow_link(driver.ui, "preset:exact");
    follow_link(driver.ui, "bug:B9");
    driver.hand.frames(2);
    CHECK(driver.ui.session.a.settings == hidden);
    CHECK(shown_pair(driver.ui.session) == nullptr);
    driver.hand.press('C');
    CHECK(driver.ui.session.a.settings == hidden);
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.one-triangle");
    CHECK_FALSE(driver.ui.session.quiz);
    CHECK(driver.ui.session.a.settings.viewport == Viewport{20, 20});
}

TEST_CASE("The key C ends a mistake as the button does") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.B5");
    driver.hand.click("lab.on");
    driver.hand.press('C');
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.hand.find("lab.on").visible);
    driver.hand.press('C');
    CHECK_FALSE(is_on(driver.ui.session, "B5"));
}

TEST_CASE("The Scene menu survives the loss of the scenes") {
    const test::TemporaryFolder folder;
    Driver driver(lit_room(200));
    setenv("RASTERWALK_LESSONS", folder.file("nowhere").c_str(), 1);
    driver.hand.click("menu.Scene");
    unsetenv("RASTERWALK_LESSONS");
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("nowhere"));
}

TEST_CASE("In a small window the laboratory's buttons can be reached") {
    for (const SmallWindow& window : test::some_of(small_windows, 2)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver(lit_room(200), window.size, window.text_scale);
        driver.ui.session.tab = "lab";
        driver.hand.frames(4);
        for (const char* name : {"lab.B9", "lab.on", "lab.scene", "lab.mode.bugs", "lab.mode.quiz",
                                 "lab.mode.result"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
        driver.hand.click("lab.mode.quiz");
        driver.hand.click("lab.quiz.start");
        for (const char* name : {"lab.choice.B3", "lab.guess", "lab.hint", "lab.give_up"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
    }
}

TEST_CASE("The laboratory opens on the mistake that is on") {
    for (const char* id : {"B10", "B9", "B2"}) {
        INFO(id);
        ViewOptions options;
        options.bug = id;
        options.given["tab"] = {"lab"};
        Driver driver(open_view(options));
        driver.hand.rest();
        CHECK(is_on(driver.ui.session, id));
        CHECK(driver.ui.lab.chosen == id);
        CHECK(driver.hand.find("lab.off").visible); // the box has the button to turn it off
        // What the student then looks at stays.
        driver.hand.click("lab.B3");
        driver.hand.frames(5);
        CHECK(driver.ui.lab.chosen == "B3");
    }
}

} // namespace rasterwalk
