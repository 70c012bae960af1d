// No edge cuts through a line of text, whatever is open, in any window.

#include <string>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

std::vector<std::string> cut_lines() {
    std::vector<std::string> cut;
    for (const ScreenText& line : screen_text()) {
        if (line.is_cut) cut.push_back(line.window + ": " + line.words);
    }
    return cut;
}

} // namespace

TEST_CASE("No line of a menu, a sheet or a list is cut in any window") {
    for (const SmallWindow& window : test::some_of(all_windows(), 3)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        for (const auto& [key, held] : {std::pair<int, Modifiers>{key::f1, {}},
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
