// No edge cuts through a line of text, whatever is open, in any window.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "session/second_run.h"
#include "session/tabs.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// What is shown, and its scene.
struct Shown {
    const char* name;
    const char* scene;
    const char* tab;
    std::function<void(Driver&)> set_up;
};

void with_edge_functions(Session& session) {
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.stage = Stage::fill;
}

const std::vector<Shown>& all_shown() {
    static const std::vector<Shown> all{
        {"vertices", "lab-room.toml", "vertices",
         [](Driver& d) { d.ui.session.selection.triangle = 7; }},
        {"vertices left out", "corridor.toml", "vertices",
         [](Driver& d) { d.ui.session.selection.triangle = 0; }},
        {"clip", "corridor.toml", "clip",
         [](Driver& d) {
             d.ui.session.a.settings.clip = Clip::all;
             d.ui.session.selection.triangle = 5;
         }},
        {"culling", "inside-out.toml", "clip",
         [](Driver& d) { d.ui.session.selection.triangle = 1; }},
        {"rows", "lab-room.toml", "rows", [](Driver& d) { d.ui.session.selection.triangle = 22; }},
        {"rows of the last", "lab-room.toml", "rows",
         [](Driver& d) { d.ui.session.a.settings.stage = Stage::rows; }},
        {"rows halfway", "one-triangle.toml", "rows",
         [](Driver& d) { d.ui.session.cursor = *parse_cursor("t0/e1/s5"); }},
        {"rows outside", "sample-outside.toml", "rows", {}},
        {"inside, a pixel", "shared-edge.toml", "rows",
         [](Driver& d) {
             with_edge_functions(d.ui.session);
             d.ui.session.selection.triangle = 1;
             d.ui.session.selection.pixel = glm::ivec2(5, 5);
         }},
        {"inside, of a polygon", "dented.toml", "rows",
         [](Driver& d) {
             with_edge_functions(d.ui.session);
             d.ui.session.selection.triangle = 2;
             d.ui.session.selection.pixel = glm::ivec2(4, 11);
         }},
        {"inside, no pixel", "dented.toml", "rows",
         [](Driver& d) {
             with_edge_functions(d.ui.session);
             d.ui.session.selection.triangle = 2;
         }},
        {"inside, the room", "lab-room.toml", "rows",
         [](Driver& d) {
             d.ui.session.a.settings.coverage = Coverage::edge_functions;
             d.ui.session.selection.triangle = 21;
             d.ui.session.selection.pixel = glm::ivec2(250, 300);
         }},
        {"floats", "lab-room.toml", "microscope",
         [](Driver& d) {
             d.ui.session.a.settings.stage = Stage::edges;
             d.ui.session.selection.triangle = 7;
             d.ui.session.cursor = *parse_cursor("t7/e2/s373");
         }},
        {"fragment", "lab-room.toml", "fragment",
         [](Driver& d) { d.ui.session.selection.pixel = glm::ivec2(398, 121); }},
        {"texture", "checkered-floor.toml", "texture",
         [](Driver& d) { d.ui.session.selection.pixel = glm::ivec2(120, 140); }},
        {"history", "lab-room.toml", "history",
         [](Driver& d) { d.ui.session.selection.pixel = glm::ivec2(250, 400); }},
        {"graph", "lab-room.toml", "graph",
         [](Driver& d) { d.ui.session.selection.pixel = glm::ivec2(398, 121); }},
        {"offers to compare", "lab-room.toml", "compare", {}},
        {"compare", "lab-room.toml", "compare", [](Driver& d) { toggle_compare(d.ui); }},
        {"mistakes", "lab-room.toml", "lab", {}},
        {"what to guess", "lab-room.toml", "lab", [](Driver& d) { d.ui.lab.mode = LabMode::quiz; }},
        {"a guess", "lab-room.toml", "lab",
         [](Driver& d) {
             d.ui.lab.mode = LabMode::quiz;
             d.ui.lab.seed = 7;
             begin_quiz(d.ui);
         }},
        {"my picture", "lab-room.toml", "lab", [](Driver& d) { d.ui.lab.mode = LabMode::result; }},
        {"history of glass", "two-panes.toml", "history",
         [](Driver& d) { d.ui.session.selection.pixel = glm::ivec2(8, 7); }},
        {"settings", "lab-room.toml", "settings", {}},
    };
    return all;
}

std::vector<std::string> cut_lines() {
    std::vector<std::string> cut;
    for (const ScreenText& line : screen_text()) {
        if (line.is_cut) cut.push_back(line.window + ": " + line.words);
    }
    return cut;
}

} // namespace

TEST_CASE("No line of a panel is cut in any window") {
    for (const SmallWindow& window : test::some_of(all_windows(), 3)) {
        for (const Shown& shown : test::some_of(all_shown(), 10)) {
            INFO(shown.name << " at " << window.size.x << " x " << window.size.y << ", text "
                            << window.text_scale);
            Driver driver(shown.scene, window.size, window.text_scale);
            if (shown.set_up) shown.set_up(driver);
            driver.ui.session.tab = shown.tab;
            driver.hand.frames(frames_to_rest + 3);
            CHECK(cut_lines() == std::vector<std::string>{});
        }
    }
}

TEST_CASE("No line of a menu, a sheet or a list is cut in any window") {
    for (const SmallWindow& window : test::some_of(all_windows(), 3)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        for (const auto& [key, held] : {std::pair<int, Held>{key::f1, {}},
                                        {key::f1 + 1, {}},
                                        {'O', {.ctrl = true}},
                                        {'S', {.ctrl = true}}}) {
            CAPTURE(key);
            driver.hand.press(key, held);
            driver.hand.frames(frames_to_rest + 2);
            CHECK(cut_lines() == std::vector<std::string>{});
            driver.hand.press(key::escape);
        }
        for (const char* const menu :
             {"File", "Edit", "View", "Scene", "Lesson", "Stage", "Compare", "Walk", "Help"}) {
            INFO(menu);
            if (driver.ui.widgets.count("menu") > 0) driver.hand.click("menu");
            driver.hand.click(std::string("menu.") + menu);
            driver.hand.frames(frames_to_rest + 2);
            CHECK(cut_lines() == std::vector<std::string>{});
            driver.hand.press(key::escape);
            driver.hand.press(key::escape);
        }
        driver.hand.click("canvas.overlays");
        driver.hand.frames(frames_to_rest + 2);
        CHECK(cut_lines() == std::vector<std::string>{});
    }
}

} // namespace rasterwalk
