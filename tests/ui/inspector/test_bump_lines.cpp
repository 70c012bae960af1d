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
    CHECK(is_offered(driver.ui.session, *find_tab("texture")));
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

TEST_CASE("Texture tab and Fragment tab show how a height shifts the texture") {
    Driver driver("brick-heights.toml");
    follow_link(driver.ui, "tab:texture");
    follow_link(driver.ui, "pixel:200,136");
    driver.hand.rest();
    REQUIRE(driver.ui.results.a.inspected.fragment);
    REQUIRE(driver.ui.results.a.inspected.fragment->parallax);
    driver.hand.click("texture.parallax.height");
    CHECK(driver.ui.inspector.chosen.texture_number == "parallax.height");
    driver.hand.click("texture.parallax.shift.u");
    CHECK(driver.ui.inspector.chosen.texture_number == "parallax.shift.u");
    follow_link(driver.ui, "tab:fragment");
    driver.hand.rest();
    driver.hand.click("fragment.parallax.view.z");
    CHECK(driver.ui.inspector.chosen.fragment_number == "parallax.view.z");
    follow_link(driver.ui, "set:parallax=off");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("fragment.parallax.view.z") == 0);
}

TEST_CASE("A scene without normal maps has no settings for them") {
    Driver room;
    follow_link(room.ui, "tab:settings");
    room.hand.rest();
    CHECK(room.ui.widgets.count("setting.normal_map") == 0);
    CHECK(room.ui.widgets.count("setting.normal_map_rule") == 0);
    CHECK(room.ui.widgets.count("setting.parallax") == 0);
}

} // namespace rasterwalk
