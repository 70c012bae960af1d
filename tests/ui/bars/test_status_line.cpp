#include <algorithm>

#include "session/content.h"
#include "support/made_scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("Nothing is said about row tables before they come up") {
    Driver driver;
    const auto tells = [&] {
        driver.hand.rest();
        return driver.hand.is_visible("status.trouble");
    };
    REQUIRE(driver.ui.results.a.warnings.size() == 1);
    REQUIRE(driver.ui.results.a.warnings[0].is_of_rows);
    CHECK(tells());
    driver.hand.click("stage.edges");
    CHECK_FALSE(tells());
    driver.hand.click("stage.rows");
    CHECK(tells());
    // The whole picture is shown, but the lesson has no panel of row tables.
    open_lesson(driver.ui, "01-pinhole-camera", 0);
    CHECK_FALSE(tells());
    driver.ui.session.tab_guide.shows_all = true;
    CHECK(tells());
    // Every lesson reports that triangles are left out.
    driver.ui.session.tab_guide.shows_all = false;
    driver.ui.session.a.settings.camera.position.z = -0.5f;
    CHECK(tells());
}

TEST_CASE("The status line names the lesson that explains the trouble there is, or none") {
    Driver driver;
    const auto says = [&] {
        driver.hand.rest();
        driver.hand.hover("status.trouble");
        return words_in("Tooltip");
    };
    Settings& settings = driver.ui.session.a.settings;
    CHECK_THAT(says(), ContainsSubstring("lesson 12 explains"));
    settings.stage = Stage::edges;
    settings.camera.position.z = -0.5f;
    CHECK_THAT(says(), ContainsSubstring("lesson 17 explains"));
    settings = default_settings(*driver.ui.session.scene);
    settings.stage = Stage::edges;
    settings.far = 0.01f;
    CHECK_THAT(says(), ContainsSubstring("goes on.") && !ContainsSubstring("explains why"));
}

TEST_CASE("Samples outside their row table are shown by a click on the status line") {
    Driver driver;
    driver.hand.click("status.show_outside");
    CHECK(driver.ui.session.tab == "rows");
    REQUIRE(driver.ui.session.selection.triangle);
    driver.ui.session.cursor = cursor_end;
    driver.hand.rest();
    CHECK(driver.hand.find("rows.outside.0").visible);
    // Nothing is offered where there is none.
    driver.hand.click("stage.edges");
    CHECK_FALSE(driver.hand.is_visible("status.show_outside"));
}

TEST_CASE(
    "In a small window the pixel's facts give way to the trouble one by one, the last first") {
    for (const float scale : {1.0f, 1.5f}) {
        Driver driver("lab-room.toml", {800, 600}, scale);
        driver.ui.session.selection.pixel = glm::ivec2(250, 400);
        driver.hand.rest();
        INFO(scale);
        for (const char* name : {"status.pixel", "status.trouble", "status.show_outside"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
        for (const ScreenText& line : screen_text()) {
            if (line.window == "status") CHECK(line.words.find("…") == std::string::npos);
        }
    }
}

TEST_CASE("Where there is no status line the pixel under the pointer is shown all the same") {
    struct Case {
        ImVec2 window;
        float text;
        bool is_lecture;
    };
    const Case cases[] = {{{1024, 640}, 1.5f, false},
                          {{1024, 640}, 1.5f, true},
                          {{800, 600}, 1.0f, true},
                          {{1600, 1000}, 1.0f, true}};
    for (const Case& c : cases) {
        INFO(c.window.x << " x " << c.window.y << ", text " << c.text);
        Driver driver("lab-room.toml", c.window, c.text);
        open_lesson(driver.ui, "08-depth-buffer", 1);
        if (c.is_lecture) driver.hand.press(key::f5);
        driver.hand.leave();
        CHECK(driver.ui.widgets.contains("walk.words"));
        driver.hand.hover("canvas");
        driver.hand.rest();
        REQUIRE(driver.ui.canvas.hovered_pixel);
        REQUIRE(driver.ui.widgets.contains("status.pixel"));
        CHECK(driver.ui.widgets.at("status.pixel").is_whole);
        CHECK_FALSE(driver.ui.widgets.contains("walk.words"));
        const glm::ivec2 pixel = *driver.ui.canvas.hovered_pixel;
        const std::string place =
            "pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
        std::string words;
        for (const ScreenText& text : screen_text(8.0f)) {
            if (text.window == "transport" && text.words.find(place) != std::string::npos)
                words = text.words;
        }
        INFO(words);
        const std::size_t inverse = words.find("1/z ");
        REQUIRE(inverse != std::string::npos);
        const std::size_t depth = words.find(" z ", inverse);
        REQUIRE(depth != std::string::npos);
        // Both are there, with all their digits.
        const double product =
            std::stod(words.substr(inverse + 4)) * std::stod(words.substr(depth + 3));
        CHECK(product == Approx(1.0).margin(1e-3));
        driver.hand.leave();
        CHECK(driver.ui.widgets.contains("walk.words"));
    }
}

TEST_CASE("Work too long for one frame of the window goes on in the next ones") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_scene(session, test::made_scene(120'000));
    Driver driver(std::move(session));
    const RunResults& a = driver.ui.results.a;
    REQUIRE_FALSE(a.is_drawn());
    CHECK(is_animating(driver.ui));
    CHECK_THAT(work_words(driver.ui.results),
               ContainsSubstring("drawn") && ContainsSubstring("of 120 000 triangles"));
    CHECK(driver.ui.widgets.contains("status.trouble"));
    int frames = 0;
    for (; !a.is_drawn(); ++frames) {
        const double before = a.replay.work().before(a.replay.drawn());
        driver.hand.frames(1);
        // A frame builds what it shows at most twice.
        const double part = a.replay.work().before(a.replay.drawn()) - before;
        CHECK(part <= 2.0 * frame_limit.at_once);
        REQUIRE(part > 0.0);
    }
    CHECK(frames > 3);
    CHECK(work_words(driver.ui.results).empty());
    CHECK_FALSE(is_animating(driver.ui));
    // A step of the camera starts again, once what it needs is prepared.
    driver.ui.session.a.settings.camera.yaw += 0.01f;
    driver.hand.frames(1);
    REQUIRE(a.is_frame_late);
    CHECK(a.is_drawn());
    CHECK(is_animating(driver.ui));
    for (int late = 0; a.is_frame_late; ++late) {
        REQUIRE(late < 100);
        driver.hand.frames(1);
    }
    CHECK(a.frame.settings.camera == driver.ui.session.a.settings.camera);
    CHECK_FALSE(a.is_drawn());
}

TEST_CASE("While a large picture turns, the line says that the fast engine draws it") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_scene(session, test::made_scene(60'000));
    Driver driver(std::move(session));
    const RunResults& a = driver.ui.results.a;
    const auto status = [&] {
        const auto place = driver.ui.widgets.find("status.trouble");
        return place != driver.ui.widgets.end() ? place->second.text : std::string();
    };
    const auto come_to_rest = [&] {
        for (int i = 0; is_working(driver.ui.results); ++i) {
            REQUIRE(i < 500);
            driver.hand.frames(1);
        }
    };
    come_to_rest();
    CHECK(status().find("fast engine") == std::string::npos);
    for (int i = 0; i < 3; ++i) {
        driver.ui.session.a.settings.camera.yaw += 0.01f;
        driver.hand.frames(1);
        CHECK(status() == "fast engine, while it moves");
        CHECK(driver.ui.canvas.picture.number == a.preview.number);
    }
    while (driver.ui.results.hand.has_moved())
        driver.hand.frames(1);
    CHECK(status().starts_with("fast engine, until the steps are drawn: "));
    CHECK(driver.ui.canvas.picture.number == a.preview.number);
    come_to_rest();
    driver.hand.frames(1);
    CHECK(status().find("fast engine") == std::string::npos);
    CHECK(driver.ui.canvas.picture.number == a.picture_number);
}

TEST_CASE("Success is not reported in the colour of failure") {
    const test::TemporaryFolder folder;
    Driver driver;
    const Theme theme = driver.ui.options.theme;
    const ImU32 fail = packed(colour_of(Meaning::fail, theme));
    const auto is_red = [&] {
        driver.hand.leave();
        return shown_colours(driver.hand.find("status.trouble")).count(fail) > 0;
    };
    driver.hand.press('S', {.ctrl = true});
    driver.hand.enter("files.path", folder.file("mine"));
    REQUIRE(driver.ui.session.notice.starts_with("Saved as "));
    CHECK_FALSE(is_red());
    driver.hand.press('C', {.ctrl = true});
    REQUIRE(driver.ui.session.notice.starts_with("Copied: "));
    CHECK_FALSE(is_red());
    driver.hand.press(key::page_down); // no lesson is open
    CHECK(is_red());
}
