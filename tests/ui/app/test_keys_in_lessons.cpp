// A lesson read and answered by keys alone: to type, to read on, and to follow a link.

#include <string>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/start/start_choice.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

constexpr const char* lesson_1 = "01-pinhole-camera";
constexpr const char* number_field = "lesson.prediction.back-wall-width.number";

void open_at(Driver& driver, const char* lesson, int step) {
    driver.hand.leave();
    open_lesson(driver.ui, lesson, step);
    driver.hand.rest();
}

const std::string& typed(Driver& driver) {
    return driver.ui.lesson.predictions.at("back-wall-width").typed;
}

/// How far the window of this name is scrolled.
float scroll_of(const char* part) {
    float scrolled = 0.0f;
    for (const ImGuiWindow* const window : GImGui->Windows) {
        if (window->WasActive && window->RootWindow == ImGui::FindWindowByName(part)) {
            scrolled += window->Scroll.y;
        }
    }
    return scrolled;
}

} // namespace

TEST_CASE("A number typed into the framed field of an answer stays there, and sets no stage") {
    Driver driver;
    open_at(driver, lesson_1, 2);
    REQUIRE(driver.tab_to(number_field));
    const Settings before = driver.ui.session.a.settings;
    for (const int digit : {'2', '5', '0'})
        driver.hand.press(digit);
    CHECK(driver.ui.session.a.settings == before);
    CHECK(typed(driver) == "250");
    driver.hand.press(key::enter);
    const PredictionView& view = driver.ui.lesson.predictions.at("back-wall-width");
    REQUIRE(view.judged);
    CHECK(view.judged->is_right);
}

TEST_CASE("Text typed while the field opens is kept, in order") {
    Driver driver;
    open_at(driver, lesson_1, 2);
    REQUIRE(driver.tab_to(number_field));
    for (const char* digit : {"1", "2", "3", "4"}) {
        ImGui::GetIO().AddInputCharactersUTF8(digit);
        driver.hand.frames();
    }
    driver.hand.rest();
    CHECK(typed(driver) == "1234");
}

TEST_CASE("No typing key does anything else while a field has the frame") {
    Driver driver;
    open_at(driver, lesson_1, 2);
    REQUIRE(driver.tab_to(number_field));
    const SessionInputs before = driver.ui.session;
    std::vector<int> keys = {key::period, key::comma, key::minus, key::left_bracket};
    for (const char letter : std::string("1789PZWASDQECJKHXFGNBRLT"))
        keys.push_back(letter);
    for (const int pressed : keys) {
        INFO(static_cast<char>(pressed));
        driver.hand.press(pressed);
        const SessionInputs& now = driver.ui.session;
        CHECK(now == before);
        CHECK(ImGui::GetIO().WantTextInput);
        driver.hand.press(key::escape); // out of the field again, with the frame
        REQUIRE(driver.ui.focus.is_shown);
        REQUIRE(driver.ui.focus.name == number_field);
        CHECK_FALSE(ImGui::GetIO().WantTextInput);
    }
}

TEST_CASE("A number that can be dragged can be typed over while it has the frame") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press(key::comma, {.ctrl = true});
    REQUIRE(driver.tab_to("setting.camera.focal_length"));
    for (const int digit : {'3', '0', '0'})
        driver.hand.press(digit);
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.a.settings.camera.focal_length == 300.0f);
    CHECK(driver.ui.focus.name == "setting.camera.focal_length");
}

TEST_CASE("Reading on gives the arrows back to the camera, and Tab brings the frame back") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}}) {
        INFO(window.x);
        Driver driver("lab-room.toml", window);
        Ui& ui = driver.ui;
        open_at(driver, lesson_1, 4);
        // To the question, in a small window past the preceding cards.
        constexpr const char* choice = "lesson.prediction.dolly-zoom.choice.0";
        for (int i = 0; i < 8 && !driver.hand.is_visible(choice); ++i)
            driver.hand.press(key::page_down);
        REQUIRE(ui.session.step == 4);
        REQUIRE(driver.tab_to(choice));
        driver.hand.press(key::enter);
        REQUIRE(ui.focus.is_shown);
        // Over the cards of the reason.
        for (int i = 0; i < 8 && ui.session.step == 4; ++i)
            driver.hand.press(key::page_down);
        REQUIRE(ui.session.step == 5);
        CHECK_FALSE(ui.focus.is_shown);
        const float z = ui.session.a.settings.camera.position.z;
        driver.hand.press(key::up);
        CHECK(ui.session.a.settings.camera.position.z > z);
        driver.hand.press(key::tab);
        CHECK(ui.focus.is_shown);
        CHECK(ui.focus.name.starts_with("lesson."));
        driver.hand.press(key::page_up);
        CHECK_FALSE(ui.focus.is_shown);
    }
}

TEST_CASE("From a new step one Tab reaches the first answer, in a strip by way of its card") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}}) {
        INFO(window.x);
        Driver driver("lab-room.toml", window);
        open_at(driver, lesson_1, 1);
        REQUIRE(driver.tab_to("lesson.next"));
        open_lesson(driver.ui, lesson_1, 2);
        driver.hand.rest();
        driver.hand.press(key::tab);
        if (driver.ui.lesson.is_strip) {
            CHECK(driver.ui.focus.name.starts_with("lesson.card."));
            driver.hand.press(key::enter);
            driver.hand.press(key::tab);
        }
        CHECK(driver.ui.focus.name == number_field);
        CHECK(driver.ui.focus.is_shown);
        CHECK(driver.hand.is_visible(number_field));
        // Only once; after that it goes on and comes around.
        driver.hand.press(key::tab);
        CHECK(driver.ui.focus.name == "lesson.prediction.back-wall-width.answer");
        driver.hand.press(key::tab);
        CHECK(driver.ui.focus.name != number_field);
        driver.hand.press(key::tab, {.shift = true});
        driver.hand.press(key::tab, {.shift = true});
        CHECK(driver.ui.focus.name == number_field);
    }
}

TEST_CASE("A key that turns no page leaves the frame where it is") {
    Driver driver;
    open_at(driver, lesson_1, 0);
    REQUIRE(driver.tab_to("walk.play"));
    driver.hand.press(key::page_up);
    CHECK(driver.ui.session.step == 0);
    CHECK(driver.ui.focus.is_shown);
    CHECK(driver.ui.focus.name == "walk.play");
}

TEST_CASE("Leaving the file sheet that the start page opened puts the frame on choosing a file") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}, ImVec2{800, 600}}) {
        INFO(window.x);
        Driver driver("lab-room.toml", window);
        driver.hand.leave();
        begin_at_start(driver.ui);
        driver.hand.rest();
        for (int i = 0; i < 3; ++i)
            driver.hand.press(key::tab);
        REQUIRE(driver.ui.focus.name == "start.picture");
        driver.hand.press(key::enter);
        REQUIRE(driver.ui.sheets.files.kind == FileSheet::Kind::result);
        driver.hand.press(key::escape);
        CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::closed);
        CHECK(driver.ui.focus.is_shown);
        CHECK(driver.ui.focus.name == "mine.choose");
        CHECK(driver.hand.is_visible("mine.choose"));
    }
}

TEST_CASE("A link pressed by a key gives the frame to what it shows") {
    const std::pair<const char*, std::string> shown[] = {
        {"show:setting.camera.focal_length", "setting.camera.focal_length"},
        {"show:walk.step", "walk.step"},
        // The three numbers of a vector are one thing to show: the first of them.
        {"show:setting.camera.position", "setting.camera.position.x"}};
    for (const auto& [link, widget] : shown) {
        INFO(link);
        Driver driver;
        open_at(driver, lesson_1, 4);
        follow_link(driver.ui, link);
        driver.hand.rest();
        CHECK_FALSE(driver.ui.focus.is_shown);
        REQUIRE(driver.tab_to("lesson.next"));
        follow_link(driver.ui, link);
        driver.hand.rest();
        CHECK(driver.ui.focus.is_shown);
        CHECK(driver.ui.focus.name == widget);
        CHECK(driver.hand.is_visible(widget));
    }

    Driver driver;
    open_at(driver, "02-moving-the-camera", 4);
    open_tab(driver.ui, "vertices");
    REQUIRE(driver.tab_to("lesson.task.turntable.link.0"));
    driver.hand.press(key::enter);
    CHECK(driver.ui.focus.name == "setting.camera.position.x");
    driver.hand.press('1');
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.a.settings.camera.position.x == 1.0f);
}

TEST_CASE("A slider in the lesson is moved and typed over while it has the frame") {
    Driver driver;
    open_at(driver, lesson_1, 3);
    const float& f = driver.ui.session.a.settings.camera.focal_length;
    REQUIRE(driver.tab_to("lesson.control.camera.focal_length"));
    driver.hand.press(key::right);
    CHECK(f == 510.0f);
    driver.hand.press(key::left);
    driver.hand.press(key::left);
    CHECK(f == 490.0f);
    for (const int digit : {'1', '0', '0', '0'})
        driver.hand.press(digit);
    driver.hand.press(key::enter);
    CHECK(f == 1000.0f);
    CHECK(driver.ui.lesson.progress.is_task_done(lesson_1, "fill-with-back-wall"));
}

TEST_CASE("Without a frame the keys that scroll move the lesson's text") {
    Driver driver("lab-room.toml", {1280, 720});
    open_at(driver, "04-edges", 2);
    CHECK(scroll_of("lesson") == 0.0f);
    driver.hand.press(key::down, {.ctrl = true});
    CHECK(scroll_of("lesson") > 0.0f);
    driver.hand.press(key::up, {.ctrl = true});
    CHECK(scroll_of("lesson") == 0.0f);
    // The widget with the frame gets these keys.
    REQUIRE(driver.tab_to("walk.play"));
    const float left = scroll_of("lesson");
    driver.hand.press(key::up, {.ctrl = true});
    driver.hand.press(key::down, {.ctrl = true});
    CHECK(scroll_of("lesson") == left);
    driver.hand.press(key::escape);
    driver.hand.press(key::up, {.ctrl = true});
    CHECK(scroll_of("lesson") < left);
}

TEST_CASE("The first prediction comes with the opening of the first lesson, and needs no number") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}, ImVec2{800, 600}}) {
        INFO(window.x);
        Driver driver("lab-room.toml", window);
        Ui& ui = driver.ui;
        driver.hand.leave();
        begin_at_start(ui);
        driver.hand.rest();
        driver.hand.press(key::enter);
        constexpr const char* last_choice = "lesson.prediction.twice-as-far.choice.2";
        int turned = 0;
        for (; turned < 8 && !driver.hand.is_visible(last_choice); ++turned)
            driver.hand.press(key::page_down);
        CHECK(turned <= 4);
        CHECK(ui.session.lesson == lesson_1);
        CHECK(ui.session.step == 0);
        REQUIRE(driver.tab_to("lesson.prediction.twice-as-far.choice.0"));
        driver.hand.press(key::enter);
        REQUIRE(ui.lesson.predictions.at("twice-as-far").judged);
        CHECK(ui.lesson.predictions.at("twice-as-far").judged->is_right);
        // The picture shows it.
        CHECK(ui.session.a.settings.camera.position.z == -7.002f);
    }
}

} // namespace rasterwalk
