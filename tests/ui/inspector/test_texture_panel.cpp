#include <string>

#include <fmt/format.h>

#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("The Texture tab is there only where the scene has a texture") {
    {
        Driver room;
        room.hand.click("group.pixel");
        room.hand.leave();
        CHECK_FALSE(is_offered(room.ui.session, *find_tab("texture")));
        CHECK(room.ui.widgets.count("tab.texture") == 0);
        CHECK(room.ui.widgets.count("tab.fragment") == 1);
    }
    Driver wall("receding-wall.toml");
    wall.hand.click("group.pixel");
    wall.hand.click("tab.texture");
    follow_link(wall.ui, "pixel:2,2"); // next to the wall
    wall.hand.rest();
    CHECK(wall.hand.is_visible("texture.none"));
    follow_link(wall.ui, "pixel:100,70");
    wall.hand.rest();
    CHECK(wall.hand.is_visible("texture.map"));
    follow_link(wall.ui, "set:texture=off");
    wall.hand.rest();
    CHECK(wall.hand.is_visible("texture.none"));
}

TEST_CASE("The Texture tab shows as many texels as were taken, and a click asks for a weight") {
    Driver driver("checkered-floor.toml");
    follow_link(driver.ui, "tab:texture");
    follow_link(driver.ui, "pixel:120,92");
    for (const auto& [filter, count] :
         {std::pair{"nearest", 1}, {"bilinear", 4}, {"mipmap", 4}, {"trilinear", 8}}) {
        follow_link(driver.ui, std::string("set:texture_filter=") + filter);
        driver.hand.rest();
        INFO(filter);
        const std::optional<FragmentReport>& report = driver.ui.results.a.inspected.fragment;
        REQUIRE(report);
        REQUIRE(report->texture);
        CHECK(report->texture->taken.count == count);
        for (int k = 0; k < 8; ++k) {
            INFO("texel " << k);
            CHECK((driver.ui.widgets.count(fmt::format("texture.texel.{}", k)) == 1) ==
                  (k < count));
        }
        const std::string last = fmt::format("texture.texel.{}", count - 1);
        driver.hand.click(last);
        CHECK(driver.ui.inspector.chosen.texture_number == last + ".weight");
    }
}

TEST_CASE("In a scene with textures their settings are on the sheet") {
    Driver driver("receding-wall.toml");
    driver.hand.click("tab.settings");
    for (const char* setting : {"texture", "texture_filter", "texture_wrap"})
        CHECK_NOTHROW(driver.hand.find(std::string("setting.") + setting));
}

} // namespace rasterwalk
