// The menus in groups.

#include <string>

#include "tests/support/catch.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/actions.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("No menu has more than seven entries without a line between them") {
    std::string menu;
    int entries = 0, lines = 0;
    for (const Action& action : action_table()) {
        if (action.menu.empty()) continue;
        const bool is_first = action.menu != menu;
        menu = action.menu;
        INFO(action.name);
        CHECK_FALSE((is_first && action.begins_group)); // nothing is above it
        entries = is_first || action.begins_group ? 1 : entries + 1;
        lines += action.begins_group ? 1 : 0;
        CHECK(entries <= 7);
    }
    CHECK(lines > 5);
}

TEST_CASE("The groups of the View menu are set apart, and the whole menu is in sight") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        if (driver.hand.is_visible("menu")) driver.hand.click("menu");
        driver.hand.click("menu.View");
        driver.hand.rest();
        float gap_in_group = 0.0f, gap_of_groups = 0.0f;
        const WidgetPlace* above = nullptr;
        for (const Action& action : action_table()) {
            if (action.menu != "View") continue;
            INFO(action.name);
            const WidgetPlace& place = driver.ui.widgets.at("menu." + action.name);
            CHECK(place.visible);
            CHECK(place.is_whole);
            if (above != nullptr) {
                const float gap = place.top_left.y - above->bottom_right.y;
                (action.begins_group ? gap_of_groups : gap_in_group) = gap;
            }
            above = &place;
        }
        CHECK(gap_of_groups > gap_in_group + 1.0f);
    }
}

TEST_CASE("The Lesson menu says that there are more lessons than it shows") {
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.5f}}) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        const std::size_t count = driver.ui.lesson.lessons.all().size();
        REQUIRE(count > 10);
        if (driver.hand.is_visible("menu")) driver.hand.click("menu");
        driver.hand.click("menu.Lesson");
        CHECK(driver.hand.find("menu.lesson.count").is_whole);
        CHECK(shown_text(driver, "menu.lesson.count") ==
              "10 of " + std::to_string(count) + " lessons; L lists all");
    }
}

} // namespace rasterwalk
