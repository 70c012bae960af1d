#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/actions.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("In a large window all keys are in sight at once, by what they are for") {
    Driver driver;
    driver.hand.press(key::f1);
    const std::vector<ScreenText> lines = screen_text();
    const auto is_seen = [&](const std::string& words) {
        return std::any_of(lines.begin(), lines.end(), [&](const ScreenText& line) {
            return line.window.starts_with("keys") && line.words.find(words) != line.words.npos &&
                   line.high.y <= 1000.0f && line.high.x <= 1600.0f;
        });
    };
    for (const Action& action : action_table()) {
        if (action.chord.key == 0) continue;
        INFO(action.name);
        CHECK(is_seen(action.title));
        CHECK(is_seen(chord_text(action.chord)));
    }
    for (const char* const title : {"Everywhere", "Mouse", "Walk", "Compare"}) {
        INFO(title);
        CHECK(is_seen(title));
    }
}

TEST_CASE("In a small window the last key is reached by scrolling") {
    Driver driver("lab-room.toml", {800, 600}, 1.5f);
    driver.hand.press(key::f1);
    CHECK_FALSE(shows_words(find_action("help.close").title, "keys"));
    for (int i = 0; i < 40; ++i)
        driver.hand.press(key::down, {.ctrl = true});
    CHECK(shows_words(find_action("help.close").title, "keys"));
}

} // namespace rasterwalk
