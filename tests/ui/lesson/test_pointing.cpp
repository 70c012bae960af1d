// The outline of what a step of a lesson points at.

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The number of the first step of a lesson, after its opening, that points at a widget.
int step_that_points(const Lesson& lesson) {
    for (std::size_t i = 1; i < lesson.steps.size(); ++i) {
        if (lesson.steps[i].state.point_at) return static_cast<int>(i);
    }
    return -1;
}

} // namespace

TEST_CASE("A step outlines what it points at, whatever is pressed, until it is used or left") {
    Driver driver;
    const LessonView& view = driver.ui.lesson;
    std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
    std::erase_if(lessons, [](const Lesson& lesson) { return step_that_points(lesson) < 0; });
    int tried = 0;
    for (const Lesson& lesson : test::some_of(lessons, 4)) {
        const int step = step_that_points(lesson);
        INFO(lesson.id << ", step " << step);
        ++tried;
        const std::string widget = *lesson.steps[static_cast<std::size_t>(step)].state.point_at;
        open_lesson(driver.ui, lesson.id, step - 1);
        driver.hand.rest();
        // As a person does, for several frames each. Cards of the previous step, or a task of it
        // below the fold, come first.
        for (int i = 0; i < 8 && driver.ui.session.step < step; ++i)
            driver.hand.hold(key::page_down, 5);
        CHECK(driver.ui.session.step == step);
        CHECK(view.pointed_at == widget);
        driver.hand.frames(20);
        CHECK(view.pointed_at == widget);
        if (step + 1 < static_cast<int>(lesson.steps.size())) {
            driver.hand.press(key::page_down);
            driver.hand.press(key::page_up);
            CHECK(view.pointed_at == widget);
        }
        driver.hand.press('G');
        driver.hand.press(key::f5);
        driver.hand.press(key::f5);
        driver.hand.press(key::tab);
        CHECK(view.pointed_at == widget);
        driver.hand.click("walk.step");
        driver.hand.leave();
        CHECK(view.pointed_at == widget);
        driver.hand.click(widget);
        CHECK(view.pointed_at.empty());
        driver.hand.press(key::escape); // what was clicked may be a list, or a field
        open_lesson(driver.ui, lesson.id, step);
        driver.hand.leave();
        CHECK(view.pointed_at == widget);
        open_lesson(driver.ui, lesson.id, 0);
        driver.hand.leave();
        CHECK(view.pointed_at == lesson.steps[0].state.point_at.value_or(""));
    }
    CHECK(tried > 0);
}

TEST_CASE("What a step points at is outlined again when a link's pointing ends") {
    Driver driver;
    const LessonView& view = driver.ui.lesson;
    open_lesson(driver.ui, "02-moving-the-camera", 4);
    driver.hand.leave();
    REQUIRE(view.pointed_at == "setting.camera.position");
    follow_link(driver.ui, "show:walk.play");
    driver.hand.rest();
    CHECK(view.pointed_at == "walk.play");
    driver.hand.press('G');
    CHECK(view.pointed_at == "setting.camera.position");
    point_at_widget(driver.ui, "walk.play", false);
    driver.ui.lesson.is_hovered = true;
    driver.hand.frames(1);
    CHECK(view.pointed_at == "walk.play");
    driver.hand.frames(1);
    CHECK(view.pointed_at == "setting.camera.position");
    // A tab in its place: the way back to it.
    driver.open("vertices");
    driver.hand.leave();
    CHECK(view.pointed_at == "tab.settings");
    driver.hand.click("tab.settings");
    driver.hand.leave();
    CHECK(view.pointed_at == "setting.camera.position");
}

TEST_CASE("An outline in a corner of the window is whole") {
    Driver driver;
    driver.hand.leave();
    follow_link(driver.ui, "show:tab.settings");
    driver.hand.frames(2);
    driver.ui.session.tab = "rows";
    driver.hand.frames(2);
    REQUIRE(driver.ui.lesson.pointed_at == "tab.settings");
    const ImDrawList& list = *ImGui::GetForegroundDrawList();
    REQUIRE(list.VtxBuffer.Size > 0);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    // The soft border of a line may be a pixel beyond it.
    for (const ImDrawVert& vertex : list.VtxBuffer) {
        REQUIRE(vertex.pos.x <= window.x + 1.0f);
        REQUIRE(vertex.pos.y >= -1.0f);
    }
}

TEST_CASE("Nothing stops you from scrolling away from what a step points at") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "02-moving-the-camera", 4);
    driver.hand.leave();
    REQUIRE(driver.ui.widgets.at("setting.camera.position").is_whole);
    driver.hand.wheel("setting.camera.position", -8.0f);
    driver.hand.frames(6);
    CHECK_FALSE(driver.ui.widgets.at("setting.camera.position").is_whole);
    // A card that is turned brings it back.
    driver.hand.press(key::page_down);
    driver.hand.frames(6);
    CHECK(driver.ui.lesson.pointed_at == "setting.camera.position");
    CHECK(driver.ui.widgets.at("setting.camera.position").is_whole);
}

TEST_CASE("What a step points at stays whole when a question makes the strip higher") {
    Driver driver("lab-room.toml", {1600, 1000}, 1.5f);
    open_lesson(driver.ui, "08-depth-buffer", 1);
    driver.hand.leave();
    for (int i = 0; i < 8 && driver.ui.session.step == 1; ++i) {
        INFO(i);
        const WidgetPlace& number = driver.ui.widgets.at("vertices.zinv.v0");
        CHECK(driver.ui.lesson.pointed_at == "vertices.zinv");
        CHECK(number.visible);
        CHECK(number.bottom_right.y - number.top_left.y >= driver.ui.fonts.mono->FontSize);
        driver.hand.press(key::page_down);
        driver.hand.rest();
    }
    CHECK(driver.ui.session.step == 2);
}

TEST_CASE("A setting behind the gear is outlined when the gear is clicked, in every window") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640), ImVec2(800, 600)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        const LessonView& view = driver.ui.lesson;
        point_at_widget(driver.ui, "setting.camera.focal_length", true);
        driver.hand.rest();
        CHECK(view.pointed_at == "tab.settings");
        driver.hand.click("tab.settings");
        driver.hand.leave();
        CHECK(view.pointed_at == "setting.camera.focal_length");
        CHECK(driver.ui.widgets.at("setting.camera.focal_length").visible);
        driver.hand.click("settings.search");
        CHECK(view.pointed_at.empty());

        // By its key as well.
        driver.hand.press(key::escape);
        driver.hand.press(key::escape);
        point_at_widget(driver.ui, "setting.light.power", true);
        driver.hand.rest();
        CHECK(view.pointed_at == "tab.settings");
        driver.hand.press(key::comma, {.ctrl = true});
        driver.hand.leave();
        CHECK(view.pointed_at == "setting.light.power");
        CHECK(driver.ui.widgets.at("setting.light.power").visible);
    }
}

TEST_CASE("A click anywhere but on the way to what is pointed at ends the pointing") {
    Driver driver("lab-room.toml", {800, 600});
    point_at_widget(driver.ui, "setting.camera.focal_length", true);
    driver.hand.rest();
    driver.hand.click("walk.step");
    CHECK(driver.ui.lesson.pointed_at.empty());
    driver.hand.click("tab.settings");
    CHECK(driver.ui.lesson.pointed_at.empty());
}

TEST_CASE("A search leads to a step whose setting is outlined, in a narrow window too") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640), ImVec2(800, 600)}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        driver.hand.press('L');
        driver.hand.click("lesson.search");
        driver.hand.type_text("focal");
        int hit = 0;
        while (driver.ui.lesson.found.hits.at(static_cast<std::size_t>(hit)).lesson.empty())
            ++hit; // terms come first
        driver.hand.click("lesson.hit." + std::to_string(hit));
        REQUIRE_FALSE(driver.ui.session.lesson.empty());
        const Lesson* const lesson = open_lesson_of(driver.ui);
        const auto step = static_cast<std::size_t>(driver.ui.session.step);
        const std::string meant = lesson->steps[step].state.point_at.value_or("");
        driver.hand.leave();
        CHECK(driver.ui.lesson.pointed_at == meant);
        CHECK((meant.empty() || driver.ui.widgets.at(meant).visible));
    }
}

TEST_CASE("A menu behind its button is outlined step by step") {
    Driver driver("lab-room.toml", {1024, 640});
    const LessonView& view = driver.ui.lesson;
    follow_link(driver.ui, "show:menu.Scene");
    driver.hand.rest();
    CHECK(view.pointed_at == "menu");
    driver.hand.click("menu");
    driver.hand.leave();
    CHECK(view.pointed_at == "menu.Scene");
}

TEST_CASE("What a step points at stays whole while the strip above it grows") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "02-moving-the-camera", 4);
    driver.hand.leave();
    const LessonStrip& strip = driver.ui.lesson.strip;
    REQUIRE(driver.ui.lesson.pointed_at == "setting.camera.position");
    for (std::size_t card = 0; card < strip.cards.size(); ++card) {
        driver.ui.lesson.strip.card = static_cast<int>(card);
        driver.hand.frames(6);
        CHECK(driver.ui.widgets.at("setting.camera.position").is_whole);
    }
}

} // namespace rasterwalk
