// Windows without room for three columns: projectors, half a screen, large text.

#include <algorithm>
#include <tuple>

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "ui/actions/actions.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

struct NarrowWindow {
    ImVec2 size;
    float text;
};

/// The rectangle of an ImGui window whose name begins so.
ImRect rect_of(const char* name) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(name);
    REQUIRE(window != nullptr);
    REQUIRE(window->Active);
    return window->Rect();
}

} // namespace

TEST_CASE("On a projector with large text, grid and row table are seen together") {
    for (const NarrowWindow& window :
         {NarrowWindow{{1024, 640}, 1.5f}, NarrowWindow{{1024, 640}, 1.0f},
          NarrowWindow{{800, 600}, 1.0f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        open_lesson(driver.ui, "05-row-table", 3);
        driver.hand.leave();
        const float u = driver.ui.options.text_scale;
        const WidgetPlace canvas = driver.ui.widgets.at("canvas");
        CHECK(canvas.is_whole);
        const ImRect grid(canvas.top_left, canvas.bottom_right);
        const ImRect table = rect_of("inspector");
        const ImRect strip = rect_of("lesson strip");
        const ImRect all({0, 0}, window.size);
        for (const ImRect& part : {grid, table, strip})
            CHECK(all.Contains(part));
        CHECK_FALSE(grid.Overlaps(table));
        CHECK_FALSE(strip.Overlaps(grid));
        CHECK_FALSE(strip.Overlaps(table));
        CHECK(grid.GetHeight() >= 110.0f * u);
        CHECK(grid.GetWidth() >= 200.0f * u);
        // The rows that edge 0 has written, which the step speaks of, are on the screen.
        int rows = 0;
        for (int row = 5; row <= 15; ++row) {
            const auto found = driver.ui.widgets.find("rows." + std::to_string(row) + ".left");
            rows += found != driver.ui.widgets.end() && found->second.is_whole ? 1 : 0;
        }
        CHECK(rows >= 3);
        CHECK(driver.ui.widgets.at("rows.header.left").is_whole);
    }
}

TEST_CASE(
    "In a small row table the signs of what was replaced have room, and the first row is seen") {
    for (const NarrowWindow& window :
         {NarrowWindow{{1024, 640}, 1.5f}, NarrowWindow{{800, 600}, 1.0f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        open_lesson(driver.ui, "05-row-table", 4);
        driver.hand.press(key::end);
        driver.hand.leave();
        int signs = 0;
        for (const auto& [name, place] : driver.ui.widgets)
            signs += name.ends_with(".replaced") ? 1 : 0;
        CHECK(signs > 0);
        CHECK(driver.ui.widgets.count("rows.header.count") == 0);
        open_lesson(driver.ui, "05-row-table", 2);
        driver.hand.leave();
        CHECK(driver.ui.widgets.at("rows.5.left").is_whole);
    }
}

TEST_CASE("The names of samples in a small row table have their last bracket") {
    Driver driver("lab-room.toml", {800, 600}, 1.5f);
    driver.ui.session.selection.triangle = 20;
    driver.open("rows");
    driver.hand.leave();
    int cells = 0;
    for (const auto& [name, place] : driver.ui.widgets) {
        if (!name.ends_with("_by")) continue;
        INFO(name);
        CHECK(place.bottom_right.x <=
              driver.ui.widgets.at("rows.header.right by").bottom_right.x + 1.0f);
        CHECK((name.ends_with("right_by") ||
               place.bottom_right.x <=
                   driver.ui.widgets.at("rows.header.left by").bottom_right.x + 1.0f));
        ++cells;
    }
    CHECK(cells > 0);
}

TEST_CASE("The button with three bars leads to every action of every menu") {
    for (const NarrowWindow& window :
         {NarrowWindow{{1024, 640}, 1.5f}, NarrowWindow{{640, 480}, 1.0f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        std::string menu;
        for (const Action& action : action_table()) {
            if (action.menu.empty()) continue;
            if (action.is_of_use != nullptr && !action.is_of_use(driver.ui)) continue;
            INFO(action.menu << ": " << action.title);
            if (action.menu != menu) {
                menu = action.menu;
                driver.hand.press(key::escape);
                driver.hand.click("menu");
                driver.hand.click("menu." + menu);
            }
            CHECK_NOTHROW(driver.hand.find("menu." + action.name));
        }
        // One of them does what it says, from there.
        driver.hand.press(key::escape);
        CHECK(ImGui::GetCurrentContext()->OpenPopupStack.Size == 0);
        const bool grid = driver.ui.session.canvas.grid;
        driver.hand.click("menu");
        driver.hand.click("menu.View");
        driver.hand.click("menu.view.grid");
        CHECK(driver.ui.session.canvas.grid != grid);
        CHECK(ImGui::GetCurrentContext()->OpenPopupStack.Size == 0);
        driver.hand.click("menu");
        driver.hand.click("menu.Lesson");
        driver.hand.click("menu.lesson.05-row-table");
        CHECK(driver.ui.session.lesson == "05-row-table");
    }
}

TEST_CASE("Escape closes the menus behind the button, wherever the pointer rests") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.hand.click("menu");
    driver.hand.click("menu.Walk");
    REQUIRE(ImGui::GetCurrentContext()->OpenPopupStack.Size == 2);
    driver.hand.press(key::escape);
    driver.hand.frames(10);
    CHECK(ImGui::GetCurrentContext()->OpenPopupStack.Size == 0);
}

TEST_CASE("The keys are the same in a narrow window") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    driver.hand.press('3');
    CHECK(driver.ui.session.a.settings.stage == Stage::rows);
    driver.hand.press('P');
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.interpolation == Interpolation::perspective);
    driver.hand.press(key::home);
    driver.hand.press(key::period);
    CHECK(driver.ui.session.cursor != cursor_begin);
    driver.hand.press(key::comma, {.ctrl = true});
    CHECK(driver.hand.is_visible("settings.search"));
    driver.hand.press(key::escape);
    driver.hand.press(key::f1);
    CHECK(driver.hand.is_visible("keys.close"));
}

TEST_CASE("No window is too small, and none ends the program") {
    const std::vector<NarrowWindow> windows{{{320, 200}, 1.0f},  {{320, 200}, 2.5f},
                                            {{400, 900}, 1.5f},  {{640, 480}, 2.0f},
                                            {{1600, 300}, 1.0f}, {{1, 1}, 1.0f}};
    for (const NarrowWindow& window : test::some_of(windows, 3)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text);
        Driver driver("lab-room.toml", window.size, window.text);
        for (const int key : {key::f5, int{'T'}, int{'L'}, key::f1, key::escape, key::escape,
                              key::page_down, key::f5}) {
            open_lesson(driver.ui, "05-row-table", 3);
            driver.hand.press(key);
            driver.hand.rest();
            CHECK(driver.ui.session.notice.empty());
        }
        driver.ui.options.is_lecture = false;
        driver.ui.options.wished_text_scale = 1.0f;
        driver.resize({1600, 1000});
        CHECK(driver.hand.is_visible("menu.File"));
    }
}

TEST_CASE("The window changes between column and strip and keeps its place in the lesson") {
    Driver driver;
    open_lesson(driver.ui, "05-row-table", 3);
    driver.hand.leave();
    CHECK_FALSE(driver.hand.is_visible("lesson.whole"));
    driver.resize({1024, 640});
    CHECK(driver.hand.is_visible("lesson.whole"));
    CHECK(driver.ui.session.step == 3);
    for (int i = 0; i < 20 && driver.ui.session.step == 3; ++i) {
        driver.hand.click("lesson.next");
        driver.hand.leave();
    }
    driver.resize({1600, 1000});
    CHECK_FALSE(driver.hand.is_visible("lesson.whole"));
    CHECK(driver.hand.is_visible("lesson.step.4"));
    CHECK(driver.ui.session.step == 4);
}

TEST_CASE("Picture and outside together fold the lesson to a strip that leaves the inspector") {
    Driver driver;
    open_lesson(driver.ui, "08-depth-buffer", 2);
    driver.hand.press(key::digit_0 + 9);
    driver.hand.leave();
    CHECK(driver.hand.is_visible("lesson.whole"));
    CHECK(driver.hand.is_visible("menu.File"));
    const ImRect strip = rect_of("lesson strip"), inspector = rect_of("inspector");
    CHECK(strip.Max.x <= inspector.Min.x);
    CHECK(strip.Min.y == inspector.Min.y);
    driver.hand.click("lesson.whole");
    driver.hand.leave();
    CHECK(driver.hand.is_visible("lesson.list"));
}

TEST_CASE("The lesson keeps its column if picture and view from outside have room for each pixel") {
    // The corridor's picture is 320 wide, the room's 500.
    for (const auto& [lesson, step, window, is_strip] :
         {std::tuple{"17-near-plane", 4, ImVec2(1600, 1000), true},
          std::tuple{"17-near-plane", 4, ImVec2(1750, 1000), false},
          std::tuple{"31-shadows", 1, ImVec2(1750, 1000), true},
          std::tuple{"31-shadows", 1, ImVec2(1600, 1000), true},
          std::tuple{"31-shadows", 1, ImVec2(2000, 1200), false}}) {
        INFO(lesson << " at " << window.x);
        Driver driver("lab-room.toml", window);
        open_lesson(driver.ui, lesson, step);
        driver.ui.session.canvas.shows = CanvasShows::both;
        driver.hand.leave();
        driver.hand.rest();
        CHECK(driver.ui.lesson.is_strip == is_strip);
        CHECK(driver.ui.canvas.place.scale >= 1.0f);
    }
}

} // namespace rasterwalk
