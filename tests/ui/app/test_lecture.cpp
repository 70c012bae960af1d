// The lecture mode.

#include <algorithm>

#include "lessons/progress.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/actions.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/kept_options.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

bool is_there(const Driver& driver, const std::string& name) {
    return driver.ui.widgets.count(name) > 0;
}

} // namespace

TEST_CASE("In a lecture Page down walks a lesson to its end, and Page up back") {
    Driver driver("lab-room.toml", {1024, 640});
    const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    const Lesson& lesson = lessons.at(4);
    open_lesson(driver.ui, lesson.id, 0);
    driver.hand.press(key::f5);
    REQUIRE(driver.ui.options.is_lecture);
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    // To the end of the last step, card by card.
    const auto place = [&] {
        driver.hand.leave();
        return std::pair{driver.ui.session.step, driver.ui.lesson.strip.card};
    };
    std::vector<std::pair<int, int>> walked{place()};
    const auto revealed = [&] {
        const auto& all = driver.ui.lesson.predictions;
        return std::count_if(all.begin(), all.end(),
                             [](const auto& one) { return one.second.judged.has_value(); });
    };
    // A card of code takes more than one key to read through.
    constexpr int most_keys_of_card = 8;
    int stays = 0;
    for (int i = 0; i < 500 && stays < most_keys_of_card; ++i) {
        const auto before = revealed();
        driver.hand.press(key::page_down);
        const auto now = place();
        ++stays;
        // The answer to a question comes on its own card.
        if (now == walked.back() && revealed() > before) stays = 0;
        if (now == walked.back()) continue;
        stays = 0;
        CHECK(now > walked.back());
        CHECK(driver.ui.session.lesson == lesson.id);
        CHECK(is_there(driver, "lesson.previous"));
        walked.push_back(now);
    }
    CHECK(walked.back().first == last);
    CHECK(walked.size() > lesson.steps.size());
    for (std::size_t i = walked.size() - 1; i > 0; --i) {
        auto here = place();
        for (int key = 0; key < most_keys_of_card && here == walked[i]; ++key) {
            driver.hand.press(key::page_up);
            here = place();
        }
        INFO("card " << walked[i - 1].second << " of step " << walked[i - 1].first);
        CHECK(here.first == walked[i - 1].first);
        CHECK(here.second == walked[i - 1].second);
    }
}

TEST_CASE("In a lecture the picture is fitted, and enlarged to the triangle, by mouse and by key") {
    Driver driver("lab-room.toml", {1024, 640});
    open_lesson(driver.ui, "05-row-table", 8);
    driver.hand.press(key::f5);
    driver.hand.leave();
    driver.hand.click("canvas.zoom_triangle");
    const float enlarged = driver.ui.session.canvas.zoom;
    CHECK(enlarged > 0.0f);
    driver.hand.click("canvas.fit");
    CHECK(driver.ui.session.canvas.zoom == 0.0f);
    driver.hand.press('X');
    CHECK(driver.ui.session.canvas.zoom == enlarged);
    driver.hand.press('F');
    CHECK(driver.ui.session.canvas.zoom == 0.0f);
}

TEST_CASE("In a lecture the picture has half of the window, from bar to bar") {
    for (const ImVec2 window : {ImVec2(1024, 640), ImVec2(1280, 800), ImVec2(1920, 1080)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        open_lesson(driver.ui, "10-light-per-pixel", 2);
        driver.hand.press(key::f5);
        driver.hand.leave();
        driver.hand.rest();
        // The room is as high as it is wide: it is seen at this size.
        const float height = driver.ui.canvas.frame_bottom - driver.ui.canvas.frame_top;
        CHECK(height > 0.68f * window.y);
        CHECK(driver.ui.canvas.place.scale * 500.0f > 0.6f * window.y);
        // Nothing of the strip is cut, and its text can be read on.
        CHECK(driver.ui.lesson.strip.is_at_side);
        CHECK(is_there(driver, "lesson.next"));
        CHECK(driver.ui.widgets.at("lesson.next").is_whole);
        CHECK(driver.ui.widgets.at("lesson.whole").is_whole);
        CHECK(driver.ui.widgets.at("lesson.card.text").is_whole);
    }
    // A row table that extends the picture's rows is as high as the picture.
    Driver rows("one-triangle.toml", {1280, 800});
    open_lesson(rows.ui, "05-row-table", 3);
    rows.hand.press(key::f5);
    rows.hand.leave();
    rows.hand.rest();
    CHECK_FALSE(rows.ui.lesson.strip.is_at_side);
}

TEST_CASE("In a lecture without a lesson Page down draws the next piece of the chosen size") {
    Driver driver("one-triangle.toml", {1024, 640});
    driver.hand.press(key::page_down);
    CHECK_FALSE(driver.ui.session.notice.empty()); // there is no lesson to walk
    driver.hand.press(key::f5);
    driver.hand.press('3');
    for (const Granularity size : {Granularity::moment, Granularity::line}) {
        driver.ui.session.play.granularity = size;
        driver.hand.press(key::home);
        driver.hand.press(key::period);
        driver.hand.press(key::period);
        const Cursor by_step = driver.ui.session.cursor;
        driver.hand.press(key::home);
        driver.hand.press(key::page_down);
        const Cursor first = driver.ui.session.cursor;
        driver.hand.press(key::page_down);
        CHECK(driver.ui.session.cursor == by_step);
        CHECK(first != by_step);
        driver.hand.press(key::page_up);
        CHECK(driver.ui.session.cursor == first);
    }
}

TEST_CASE("Leaving a lecture restores everything") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        open_lesson(driver.ui, "05-row-table", 3);
        driver.hand.press('T');
        driver.hand.leave();
        const auto places = [&] {
            driver.hand.leave();
            driver.hand.rest();
            std::vector<std::string> all;
            for (const auto& [name, place] : driver.ui.widgets) {
                all.push_back(name + " " + std::to_string(place.top_left.x) + " " +
                              std::to_string(place.top_left.y) + " " +
                              std::to_string(place.bottom_right.x) + " " +
                              std::to_string(place.bottom_right.y));
            }
            std::sort(all.begin(), all.end());
            return all;
        };
        const std::vector<std::string> before = places();
        const SessionInputs inputs = driver.ui.session;
        const std::string options = options_text(driver.ui.options);
        const float scale = driver.ui.options.text_scale;
        driver.hand.press(key::f5);
        CHECK(places() != before);
        CHECK(driver.ui.options.text_scale > scale);
        driver.hand.press(key::escape);
        CHECK_FALSE(driver.ui.options.is_lecture);
        CHECK(places() == before);
        CHECK(driver.ui.options.text_scale == scale);
        CHECK(options_text(driver.ui.options) == options);
        const SessionInputs& after = driver.ui.session;
        CHECK(after == inputs);
        // By its key, and by the words in the corner.
        driver.hand.press(key::f5);
        driver.hand.press(key::f5);
        CHECK(places() == before);
        driver.hand.press(key::f5);
        driver.hand.click("lecture.leave");
        CHECK(places() == before);
    }
}

TEST_CASE("A lesson's text covered by the settings is back after a lecture") {
    Driver driver("lab-room.toml", {1024, 640});
    open_lesson(driver.ui, "05-row-table", 3);
    driver.hand.press('T');
    driver.hand.click("tab.settings");
    driver.hand.press(key::f5);
    driver.hand.press(key::escape); // the settings
    CHECK_FALSE(driver.ui.lesson.drawer_is_open);
    CHECK(driver.ui.options.is_lecture);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.options.is_lecture);
    CHECK(driver.ui.lesson.drawer_is_open);
}

TEST_CASE("On the largest screen a lecture leads to another tab by the list of tabs") {
    Driver driver("lab-room.toml", {2560, 1440});
    open_lesson(driver.ui, "06-filling", 2);
    driver.hand.press(key::f5);
    driver.hand.rest();
    point_at_widget(driver.ui, "tab.microscope", true);
    driver.hand.rest();
    INFO(driver.ui.session.notice);
    CHECK(driver.ui.lesson.pointed_at == "tabs");
    CHECK(driver.ui.session.notice.empty());
}

TEST_CASE("Escape closes what is open before it ends the lecture") {
    Driver driver("lab-room.toml", {1024, 640});
    driver.hand.press(key::f5);
    driver.hand.press('T');
    driver.hand.press(key::f1);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.sheets.is_open(Sheet::keys));
    CHECK(driver.ui.options.is_lecture);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.lesson.drawer_is_open);
    CHECK(driver.ui.options.is_lecture);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.options.is_lecture);
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.ui.options.is_lecture);
}

TEST_CASE("A lecture has no letters under 18 pixels, and nothing that distracts") {
    for (const ImVec2 window : {ImVec2(1024, 640), ImVec2(1600, 1000), ImVec2(800, 600)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        for (const int step : {0, 3, 5}) {
            open_lesson(driver.ui, "05-row-table", step);
            if (!driver.ui.options.is_lecture) driver.hand.press(key::f5);
            driver.hand.leave();
            for (const ScreenText& text : screen_text()) {
                INFO(text.window << ": " << text.words);
                CHECK(text.size >= 18.0f);
            }
            for (const char* gone : {"status.pixel", "walk.first", "walk.last", "walk.next_change",
                                     "canvas.grid", "canvas.overlays", "switch.compare", "scenes",
                                     "corner.undo", "group.runs", "menu.File"}) {
                INFO(gone);
                CHECK_FALSE(is_there(driver, gone));
            }
            for (const char* stays :
                 {"menu", "walk.play", "walk.step", "walk.back", "lesson.next", "lesson.whole",
                  "canvas", "canvas.fit", "canvas.zoom_triangle", "lecture.leave"}) {
                INFO(stays);
                REQUIRE(is_there(driver, stays));
                CHECK(driver.ui.widgets.at(stays).is_whole);
            }
        }
    }
}

TEST_CASE("A lecture says what could not be done") {
    Driver driver("lab-room.toml", {1024, 640});
    driver.hand.press(key::f5);
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "status.trouble"));
    driver.hand.press('N'); // no pixel is picked
    driver.hand.leave();
    CHECK(driver.hand.is_visible("status.trouble"));
}

TEST_CASE("A lecture is not kept, and is listed in the View menu and among the keys") {
    const test::TemporaryFolder folder;
    const std::string file = folder.file("options.toml");
    {
        Driver driver;
        keep_options(driver.ui, file);
        driver.hand.press(key::f5);
        driver.ui.options.theme = Theme::light; // so that something is written
        driver.hand.frames(3);
    }
    Driver driver;
    keep_options(driver.ui, file);
    CHECK(driver.ui.options.theme == Theme::light);
    CHECK_FALSE(driver.ui.options.is_lecture);
    CHECK(find_action("view.lecture").menu == "View");
    CHECK(chord_text(find_action("view.lecture").chord) == "F5");
    driver.hand.press(key::f1);
    CHECK(shows_words("Lecture mode", "keys"));
}

} // namespace rasterwalk
