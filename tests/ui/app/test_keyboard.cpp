// The window by keys alone: the pointer is nowhere in all of these.

#include <set>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "lessons/lesson_run.h"
#include "session/tabs.h"
#include "stages/stages.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/start/start_choice.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr int f6 = key::f1 + 5;
constexpr int most_presses = 400;

/// Everything that Tab leads to, once around.
std::set<std::string> reached(Driver& driver) {
    std::set<std::string> names;
    driver.hand.press(key::tab);
    for (int i = 0; i < most_presses && names.insert(driver.ui.focus.name).second; ++i)
        driver.hand.press(key::tab);
    return names;
}

/// How much is drawn in a colour.
int vertices_of(ImU32 colour) {
    int count = 0;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        for (const ImDrawVert& vertex : data->CmdLists[i]->VtxBuffer)
            count += vertex.col == colour ? 1 : 0;
    }
    return count;
}

} // namespace

TEST_CASE("By keys alone: from the start page through a lesson to the mistakes") {
    Driver driver;
    Ui& ui = driver.ui;
    driver.hand.leave();
    begin_at_start(ui);
    driver.hand.rest();
    driver.hand.press(key::enter);
    REQUIRE(ui.session.lesson == "01-pinhole-camera");
    CHECK_FALSE(ui.start.is_open);

    // The first prediction of the lesson, wherever it is.
    constexpr const char* number = "lesson.prediction.back-wall-width.number";
    for (int step = 0; step < 12 && ui.widgets.count(number) == 0; ++step) {
        REQUIRE(driver.tab_to("lesson.next"));
        driver.hand.press(key::enter);
    }
    REQUIRE(driver.tab_to(number));
    CHECK(driver.hand.is_visible(number));
    driver.hand.press(key::enter);
    driver.hand.type_text("100");
    driver.hand.press(key::enter);
    CHECK(ui.lesson.predictions.at("back-wall-width").judged);
    CHECK_FALSE(ui.session.play.running);

    const int step = ui.session.step;
    REQUIRE(driver.tab_to("lesson.next"));
    driver.hand.press(key::enter);
    CHECK(ui.session.step == step + 1);

    for (const StageInfo& info : stage_list()) {
        const std::string name = std::string("stage.").append(info.name);
        INFO(name);
        if (!driver.hand.is_visible(name)) continue;
        REQUIRE(driver.tab_to(name));
        driver.hand.press(key::enter);
        CHECK(step_of(ui.session.a.settings) == info.step);
    }

    CHECK_FALSE(is_settings_open(ui));
    driver.hand.press(key::comma, {.ctrl = true});
    REQUIRE(is_settings_open(ui));
    CHECK(ui.focus.name == "settings.search");
    REQUIRE(driver.tab_to("setting.camera.focal_length"));
    const float before = ui.session.a.settings.camera.focal_length;
    driver.hand.press(key::up);
    CHECK(ui.session.a.settings.camera.focal_length > before);
    driver.hand.press(key::escape);
    CHECK_FALSE(is_settings_open(ui));

    REQUIRE(driver.tab_to("canvas"));
    ui.session.selection.pixel.reset();
    driver.hand.press(key::right);
    REQUIRE(ui.session.selection.pixel);
    const glm::ivec2 pixel = *ui.session.selection.pixel;
    driver.hand.press(key::right);
    driver.hand.press(key::down);
    CHECK(*ui.session.selection.pixel == pixel + glm::ivec2(1, 1));

    REQUIRE(driver.tab_to("tabs.show_all"));
    driver.hand.press(key::enter);
    REQUIRE(driver.tab_to("group.runs"));
    driver.hand.press(key::enter);
    REQUIRE(driver.tab_to("tab.lab"));
    driver.hand.press(key::enter);
    CHECK(ui.session.tab == "lab");
    REQUIRE(driver.tab_to("lab.mode.result"));
    driver.hand.press(key::enter);
    CHECK(ui.lab.mode == LabMode::result);
}

TEST_CASE("One of several answers is reached by Tab, and given by Enter or Space") {
    for (const int given : {key::enter, key::space}) {
        Driver driver;
        Ui& ui = driver.ui;
        driver.hand.leave();
        const Lesson* with = nullptr;
        const LessonPrediction* asked = nullptr;
        for (const Lesson& lesson : ui.lesson.lessons.all()) {
            for (const LessonPrediction& prediction : lesson.predictions) {
                if (asked != nullptr || prediction.kind != LessonPrediction::Kind::choice) continue;
                with = &lesson;
                asked = &prediction;
            }
        }
        REQUIRE(asked != nullptr);
        const std::string id = asked->id;
        const int right = judge(*with, *asked, {0}, ui.session).choice;
        const std::string second = "lesson.prediction." + id + ".choice." + std::to_string(right);
        open_lesson(ui, with->id, 0);
        driver.hand.rest();
        for (int step = 0; step < 12 && ui.widgets.count(second) == 0; ++step) {
            REQUIRE(driver.tab_to("lesson.next"));
            driver.hand.press(key::enter);
        }
        REQUIRE(driver.tab_to(second));
        CHECK(driver.hand.is_visible(second));
        driver.hand.press(given);
        CHECK(ui.lesson.predictions.at(id).judged);
        CHECK_FALSE(driver.hand.is_visible(second));
        CHECK_FALSE(ui.session.play.running);
        // The frame stays on the program's reply to it.
        driver.hand.rest();
        CHECK(ui.focus.is_shown);
        CHECK(ui.focus.name == "lesson.prediction." + id + ".again");
        CHECK(driver.hand.is_visible("lesson.prediction." + id + ".verdict"));
    }
}

TEST_CASE("The first Tab shows the frame, in both themes; a click and Escape take it away") {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Driver driver;
        driver.ui.options.theme = theme;
        driver.ui.style_is_stale = true;
        driver.hand.leave();
        driver.ui.focus.name = "walk.play";
        const ImU32 colour = packed(palette(theme).link);
        const int without = vertices_of(colour);
        driver.hand.press(key::tab);
        CHECK(driver.ui.focus.name == "walk.play");
        CHECK(vertices_of(colour) > without);
        driver.hand.press(key::escape);
        CHECK(vertices_of(colour) == without);
        driver.hand.press(key::tab);
        REQUIRE(driver.ui.focus.is_shown);
        driver.hand.click("canvas.grid");
        CHECK_FALSE(driver.ui.focus.is_shown);
        CHECK(driver.ui.focus.name == "canvas.grid");
    }
}

TEST_CASE("Tab leads to every stage, tab, menu and button of the transport, and back") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}, ImVec2{800, 600}}) {
        Driver driver("lab-room.toml", window);
        driver.hand.leave();
        const std::set<std::string> found = reached(driver);
        CHECK(found.size() < most_presses);
        for (const auto& [name, place] : driver.ui.widgets) {
            const bool is_meant = name.starts_with("stage.") || name.starts_with("tab.") ||
                                  name.starts_with("menu") || name.starts_with("group.") ||
                                  name.starts_with("walk.") || name.starts_with("canvas") ||
                                  name.starts_with("corner.") || name.starts_with("lesson.");
            if (!is_meant || place.id == 0) continue;
            INFO(name << " at " << window.x);
            CHECK(found.contains(name));
        }
        for (const char* name : {"walk.first", "walk.back", "walk.play", "walk.step", "walk.last",
                                 "walk.speed", "walk.scrub", "canvas"}) {
            INFO(name << " at " << window.x);
            CHECK(found.contains(name));
        }
        CHECK(driver.tab_to("walk.play", {.shift = true}));
    }
}

TEST_CASE("F6 goes from part to part, through all of them") {
    Driver driver;
    driver.hand.leave();
    std::set<ImGuiID> parts;
    for (int i = 0; i < 12; ++i) {
        driver.hand.press(f6);
        REQUIRE(driver.ui.focus.is_shown);
        parts.insert(driver.ui.widgets.at(driver.ui.focus.name).part);
    }
    for (const char* name : {"menu.File", "stage.depth", "canvas", "walk.play"}) {
        INFO(name);
        CHECK(parts.contains(driver.ui.widgets.at(name).part));
    }
}

TEST_CASE("A menu opens by Enter, is walked by arrows, and gives the keyboard back") {
    Driver driver;
    driver.hand.leave();
    driver.ui.focus.name = "menu.View";
    driver.hand.press(key::tab);
    driver.hand.press(key::enter);
    REQUIRE(driver.hand.is_visible("menu.view.grid"));
    const bool grid = driver.ui.session.canvas.grid;
    for (int i = 0; i < 40 && driver.ui.focus.name != "menu.view.grid"; ++i)
        driver.hand.press(key::down);
    REQUIRE(driver.ui.focus.name == "menu.view.grid");
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.canvas.grid != grid);
    CHECK_FALSE(driver.hand.is_visible("menu.view.grid"));
    CHECK(driver.ui.focus.name == "menu.View");

    driver.hand.press(key::enter);
    REQUIRE(driver.hand.is_visible("menu.view.grid"));
    driver.hand.press(key::escape);
    CHECK_FALSE(driver.hand.is_visible("menu.view.grid"));
    CHECK(driver.ui.focus.name == "menu.View");
    CHECK(driver.ui.focus.is_shown);
}

TEST_CASE("A list opened by keys begins at the current entry") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press(key::comma, {.ctrl = true});
    REQUIRE(driver.tab_to("setting.rounding"));
    driver.hand.press(key::enter);
    driver.hand.rest();
    CHECK(driver.ui.focus.name == "setting.rounding=truncate");
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.a.settings.vertex_rounding == VertexRounding::truncate);
}

TEST_CASE("A list of words is chosen from by keys") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press(key::comma, {.ctrl = true});
    REQUIRE(driver.tab_to("setting.rounding"));
    driver.hand.press(key::enter);
    REQUIRE(driver.hand.is_visible("setting.rounding=floor"));
    REQUIRE(driver.tab_to("setting.rounding=floor"));
    driver.hand.press(key::enter);
    CHECK(driver.ui.focus.name == "setting.rounding");
    CHECK_FALSE(driver.hand.is_visible("setting.rounding=floor"));
    CHECK(driver.ui.session.a.settings.vertex_rounding == VertexRounding::floor);
}

TEST_CASE("Arrows and Space go to the framed widget, so camera and time stay") {
    Driver driver;
    driver.hand.leave();
    const Settings before = driver.ui.session.a.settings;
    driver.ui.focus.name = "canvas.grid";
    driver.hand.press(key::tab);
    const bool grid = driver.ui.session.canvas.grid;
    driver.hand.press(key::space);
    CHECK(driver.ui.session.canvas.grid != grid);
    CHECK_FALSE(driver.ui.session.play.running);
    for (const int arrow : {key::up, key::left, key::right, key::down}) {
        driver.hand.press(arrow);
        CHECK(driver.ui.session.a.settings == before);
    }
    driver.hand.press(key::escape);
    driver.hand.press(key::up);
    CHECK_FALSE(driver.ui.session.a.settings == before);
    driver.hand.press(key::space);
    CHECK(driver.ui.session.play.running);
}

TEST_CASE("Anything that can be dragged can be moved by arrows") {
    Driver driver;
    driver.hand.leave();
    Ui& ui = driver.ui;
    const auto frame = [&](const char* name) {
        ui.focus.is_shown = false;
        ui.focus.name = name;
        driver.hand.press(key::tab);
        REQUIRE(ui.focus.name == name);
    };
    frame("walk.scrub");
    driver.hand.press(key::home);
    const Cursor first = ui.results.a.cursor;
    driver.hand.press(key::right);
    const Cursor second = ui.results.a.cursor;
    CHECK(first < second);
    driver.hand.press(key::left);
    CHECK(ui.results.a.cursor < second);
    frame("walk.speed");
    const Speed speed = ui.session.play.speed;
    driver.hand.press(key::up);
    CHECK_FALSE(ui.session.play.speed == speed);
    frame("splitter.inspector");
    const float right = ui.widgets.at("canvas").bottom_right.x;
    driver.hand.press(key::left);
    CHECK(ui.widgets.at("canvas").bottom_right.x < right);
    open_tab(ui, "settings");
    driver.hand.rest();
    frame("setting.camera.position.y");
}

TEST_CASE("A number is typed by keys, and Tab leaves every field") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press(key::comma, {.ctrl = true});
    REQUIRE(driver.tab_to("settings.search"));
    driver.hand.press(key::enter);
    REQUIRE(ImGui::GetIO().WantTextInput);
    driver.hand.type_text("focal");
    CHECK(driver.ui.inspector.setting_search == "focal");
    driver.hand.press(key::tab);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
    CHECK(driver.ui.focus.name == "settings.close");
    CHECK(driver.ui.inspector.setting_search == "focal");
    REQUIRE(driver.tab_to("setting.camera.focal_length"));
    driver.hand.press(key::enter);
    REQUIRE(ImGui::GetIO().WantTextInput);
    driver.hand.press('A', {.ctrl = true});
    driver.hand.type_text("300");
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.a.settings.camera.focal_length == 300.0f);
    driver.hand.press(key::tab);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
}

TEST_CASE("The sheet for files by keys: a folder is entered, and a file opened") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press('O', {.ctrl = true});
    REQUIRE(driver.tab_to("files.own"));
    driver.hand.press(key::enter);
    REQUIRE(driver.tab_to("files.entry.scenes"));
    driver.hand.press(key::enter);
    REQUIRE(driver.tab_to("files.entry.fence.toml"));
    driver.hand.press(key::enter);
    CHECK(driver.ui.sheets.files.path == "fence.toml");
    driver.hand.press(key::enter);
    CHECK(driver.ui.session.scene->path.ends_with("fence.toml"));
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::closed);
}

TEST_CASE("Long text is scrolled by keys: the sheet of keys, and a lesson's text") {
    Driver driver("lab-room.toml", {1200, 640});
    driver.hand.leave();
    const auto scroll_of = [&] {
        float scrolled = 0.0f;
        for (const ImGuiWindow* const window : GImGui->Windows)
            scrolled += window->WasActive ? window->Scroll.y : 0.0f;
        return scrolled;
    };
    const float before = scroll_of();
    driver.hand.press(key::f1);
    driver.hand.press(key::down, {.ctrl = true});
    CHECK(scroll_of() > before);
    driver.hand.press(key::up, {.ctrl = true});
    CHECK(scroll_of() == before);
    driver.hand.press(key::escape);

    open_lesson(driver.ui, "04-edges", 2);
    driver.ui.lesson.drawer_is_open = true;
    driver.hand.rest();
    REQUIRE(driver.tab_to("lesson.next"));
    const float unread = scroll_of();
    driver.hand.press(key::down, {.ctrl = true});
    CHECK(scroll_of() > unread);
}

TEST_CASE("Shift and F1 explain the widget with the frame") {
    Driver driver;
    driver.hand.leave();
    driver.ui.focus.name = "walk.play";
    driver.hand.press(key::tab);
    const int without = ImGui::GetDrawData()->TotalVtxCount;
    driver.hand.press(key::f1, {.shift = true});
    CHECK(ImGui::GetDrawData()->TotalVtxCount > without);
    driver.hand.press(key::f1, {.shift = true});
    CHECK(ImGui::GetDrawData()->TotalVtxCount == without);
}

TEST_CASE("Tab stays on the sheet that has the keyboard, and nothing below it is reached") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}}) {
        Driver driver("lab-room.toml", window);
        Ui& ui = driver.ui;
        driver.hand.leave();
        driver.hand.press(key::f1);
        for (int i = 0; i < 4; ++i) {
            driver.hand.press(key::tab);
            CHECK(ui.focus.is_shown);
            CHECK(ui.focus.name == "keys.close");
        }
        const ImRect sheet = ImGui::FindWindowByName("keys")->Rect();
        const auto is_below = [&](const WidgetPlace& place) {
            return sheet.Contains({place.top_left, place.bottom_right});
        };
        driver.hand.press(f6);
        std::set<std::string> names;
        while (names.insert(ui.focus.name).second) {
            INFO(ui.focus.name << " at " << window.x);
            CHECK(ui.focus.name != "keys.close");
            CHECK_FALSE(is_below(ui.widgets.at(ui.focus.name)));
            driver.hand.press(key::tab);
        }
        CHECK(names.size() > 10);
        for (int i = 0; i < 12 && ui.focus.name != "keys.close"; ++i)
            driver.hand.press(f6);
        CHECK(ui.focus.name == "keys.close");
    }
}

TEST_CASE("A sheet takes the keyboard from what it covers, and gives it back") {
    Driver driver;
    Ui& ui = driver.ui;
    driver.hand.leave();
    ui.sheets.show(Sheet::keys);
    driver.hand.rest();
    const ImRect sheet = ImGui::FindWindowByName("keys")->Rect();
    std::string below;
    for (const auto& [name, place] : ui.widgets) {
        const bool is_stop = place.id != 0 && place.visible && name != "keys.close";
        if (is_stop && sheet.Contains({place.top_left, place.bottom_right})) below = name;
    }
    REQUIRE_FALSE(below.empty());
    driver.hand.press(key::escape);
    ui.focus.name = below;
    driver.hand.press(key::tab);
    REQUIRE(ui.focus.name == below);
    ui.sheets.show(Sheet::keys);
    driver.hand.rest();
    CHECK(ui.focus.name == "keys.close");
    driver.hand.press(key::escape);
    CHECK(ui.focus.name == below);
    CHECK(ui.focus.is_shown);
}

TEST_CASE("A sheet opened from a menu has the keyboard") {
    Driver driver;
    driver.hand.leave();
    driver.ui.focus.name = "menu.Help";
    driver.hand.press(key::tab);
    driver.hand.press(key::enter);
    REQUIRE(driver.tab_to("menu.help.keys"));
    driver.hand.press(key::enter);
    REQUIRE(driver.ui.sheets.is_open(Sheet::keys));
    CHECK(driver.ui.focus.name == "keys.close");
    driver.hand.press(key::escape);
    CHECK(driver.ui.focus.name == "menu.Help");
}

TEST_CASE("Arrows that move the frame change nothing, however long they are held") {
    Driver driver("one-triangle.toml");
    Ui& ui = driver.ui;
    driver.hand.leave();
    driver.open("rows");
    driver.hand.leave();
    REQUIRE(ui.widgets.count("bench.vertex.0.x") == 1);
    const std::shared_ptr<const Scene> scene = ui.session.scene;
    const Settings settings = ui.session.a.settings;
    for (const int arrow : {key::right, key::left}) {
        ui.focus.is_shown = false;
        ui.focus.name = "tab.rows";
        driver.hand.press(key::tab);
        REQUIRE(ui.focus.name == "tab.rows");
        for (int i = 0; i < 30; ++i) {
            driver.hand.press(arrow);
            INFO(ui.focus.name);
            CHECK_FALSE(ui.widgets.at(ui.focus.name).takes_arrows);
        }
        CHECK(ui.focus.name != "tab.rows");
        driver.hand.hold(arrow, 200);
        CHECK(ui.session.scene == scene);
        CHECK(ui.session.a.settings == settings);
    }
}

} // namespace rasterwalk
