#include <string>

#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE(
    "The Fragment tab shows how a normal map bends the normal, and where each number is from") {
    Driver driver("studs.toml");
    CHECK_FALSE(is_offered(driver.ui.session, *find_tab("texture")));
    follow_link(driver.ui, "tab:fragment");
    follow_link(driver.ui, "pixel:42,26");
    driver.hand.rest();
    const std::optional<FragmentReport>& report = driver.ui.results.a.inspected.fragment;
    REQUIRE(report);
    REQUIRE(report->bump);
    CHECK(report->bump->arrow.y > 0.4f);
    driver.hand.click("fragment.bump.arrow.y");
    CHECK(driver.ui.inspector.chosen.fragment_number == "bump.arrow.y");
    driver.hand.click("fragment.bump.normal.y");
    CHECK(driver.ui.inspector.chosen.fragment_number == "bump.normal.y");
    follow_link(driver.ui, "set:normal_map=off");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("fragment.bump.arrow.y") == 0);
    for (const char* setting : {"normal_map", "normal_map_rule"}) {
        follow_link(driver.ui, "tab:settings");
        CHECK_NOTHROW(driver.hand.find(std::string("setting.") + setting));
    }
}

TEST_CASE("A scene without normal maps has no settings for them") {
    Driver room;
    follow_link(room.ui, "tab:settings");
    room.hand.rest();
    CHECK(room.ui.widgets.count("setting.normal_map") == 0);
    CHECK(room.ui.widgets.count("setting.normal_map_rule") == 0);
}

} // namespace rasterwalk
