#include <string>

#include <fmt/format.h>

#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
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

TEST_CASE("The Texture tab shows whichever map acts, and an arrow for the normal map") {
    Driver driver("brick-heights.toml");
    follow_link(driver.ui, "tab:texture");
    follow_link(driver.ui, "pixel:160,118");
    driver.hand.rest();
    const std::optional<FragmentReport>& report = driver.ui.results.a.inspected.fragment;
    REQUIRE(report);
    REQUIRE(report->texture);
    REQUIRE(report->bump);
    REQUIRE(report->parallax);
    CHECK_FALSE(driver.hand.is_visible("texture.arrow"));
    for (const auto& [map, number] : {std::pair{"normal_map", "bump.colour.red"},
                                      {"height_map", "parallax.stored"},
                                      {"texture", "texture.texel.0.weight"}}) {
        INFO(map);
        driver.hand.click(std::string("texture.show.") + map);
        driver.hand.rest();
        CHECK((driver.ui.widgets.count("texture.arrow") == 1) ==
              (map == std::string("normal_map")));
        CHECK(driver.ui.widgets.count("texture.texel.0") == 1);
        driver.hand.click("texture.texel.0");
        CHECK(driver.ui.inspector.chosen.texture_number == number);
    }
}

TEST_CASE("A surface with only a normal map has the Texture tab") {
    Driver driver("studs.toml");
    follow_link(driver.ui, "pixel:80,80");
    follow_link(driver.ui, "tab:texture");
    driver.hand.rest();
    const std::optional<FragmentReport>& report = driver.ui.results.a.inspected.fragment;
    REQUIRE(report);
    REQUIRE(report->bump);
    CHECK_FALSE(report->texture);
    CHECK(is_offered(driver.ui.session, *find_tab("texture")));
    CHECK(driver.hand.is_visible("texture.map"));
    CHECK(driver.ui.widgets.count("texture.arrow") == 1);
    CHECK(driver.ui.widgets.count("texture.show.normal_map") == 0);
    driver.hand.click("texture.arrow.x");
    CHECK(driver.ui.inspector.chosen.texture_number == "bump.arrow.x");
    follow_link(driver.ui, "set:normal_map=off");
    driver.hand.rest();
    CHECK(driver.hand.is_visible("texture.none"));
}

TEST_CASE("Where u or v is not a number, the map has no ring and says so") {
    Driver driver("beyond-the-texture.toml");
    follow_link(driver.ui, "set:stage=fill"); // no depth test, in which the fragment would fail
    follow_link(driver.ui, "set:interpolation=perspective");
    follow_link(driver.ui, "pixel:64,64");
    follow_link(driver.ui, "tab:texture");
    const auto help = [&] {
        driver.hand.hover("texture.map");
        return words_in("Tooltip");
    };
    CHECK_THAT(help(), Catch::Matchers::ContainsSubstring("The ring"));
    // The row takes no zinv, so that u and v are 0 / 0.
    follow_link(driver.ui, "set:row_search=column_only");
    driver.hand.rest();
    CHECK(fault_of_frame() == "");
    CHECK_THAT(help(), Catch::Matchers::ContainsSubstring("There is no ring"));
}

TEST_CASE("In a scene with textures their settings are on the sheet") {
    Driver driver("receding-wall.toml");
    driver.hand.click("tab.settings");
    for (const char* setting : {"texture", "texture_filter", "texture_wrap"})
        CHECK_NOTHROW(driver.hand.find(std::string("setting.") + setting));
}

} // namespace rasterwalk
