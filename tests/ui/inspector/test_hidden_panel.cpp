#include <string>

#include "inspect/hidden_ways.h"
#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("The Hidden tab comes with an order, counts all ways and changes to another") {
    Driver driver;
    follow_link(driver.ui, "set:stage=depth");
    driver.hand.click("group.triangle");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("tab.hidden") == 0);
    follow_link(driver.ui, "set:hidden=painter");
    driver.hand.rest();
    driver.hand.click("tab.hidden");
    driver.hand.rest();
    const std::vector<HiddenWay> ways =
        hidden_ways(*driver.ui.session.scene, driver.ui.session.a.settings);
    for (const HiddenWay& way : ways) {
        const std::string name = "hidden." + std::string(word_of(way.way));
        CAPTURE(name);
        const auto text = [&](const char* column) {
            return driver.ui.widgets.at(name + column).text;
        };
        CHECK(text(".wrong") == std::to_string(way.wrong));
        CHECK(text(".compared") == std::to_string(way.counts.comparisons));
        CHECK(text(".bytes") == std::to_string(way.counts.memory));
    }
    driver.hand.click("hidden.way.bsp");
    driver.hand.rest();
    CHECK(driver.ui.session.a.settings.hidden == Hidden::bsp);
    driver.hand.click("hidden.way.depth_buffer");
    driver.hand.rest();
    CHECK(driver.ui.session.a.settings.hidden == Hidden::depth_buffer);
    // The open tab stays, so that the way back is one click.
    CHECK(driver.ui.widgets.count("hidden.way.painter") == 1);
    driver.hand.click("tab.vertices");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("tab.hidden") == 0);
}

TEST_CASE("The Hidden tab shows the place of a triangle in the order with a depth buffer too") {
    Driver driver;
    follow_link(driver.ui, "set:stage=depth&draw_order=near_first");
    follow_link(driver.ui, "triangle:7");
    driver.hand.click("group.triangle");
    driver.hand.rest();
    driver.hand.click("tab.hidden");
    driver.hand.rest();
    CHECK_THAT(driver.ui.widgets.at("hidden.place").text,
               Catch::Matchers::ContainsSubstring("Sorted by depth, the nearest first."));
    follow_link(driver.ui, "set:draw_order=far_first");
    driver.hand.rest();
    CHECK_THAT(driver.ui.widgets.at("hidden.place").text,
               Catch::Matchers::ContainsSubstring("Sorted by depth, the farthest first."));
    // Both orders are those of a depth buffer.
    CHECK(hidden_rule(driver.ui.session.a.settings) == Hidden::depth_buffer);
    follow_link(driver.ui, "set:draw_order=scene");
    driver.hand.rest();
    driver.hand.click("tab.vertices");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("tab.hidden") == 0);
}

} // namespace rasterwalk
