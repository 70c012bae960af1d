#include <catch2/catch.hpp>

#include "settings/setting_table.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("A number typed into a setting takes effect at once") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.enter("setting.camera.focal_length", "300");
    CHECK(driver.ui.session.a.settings.camera.focal_length == 300.0f);
    CHECK(driver.ui.results.a.frame.settings.camera.focal_length == 300.0f);
}

TEST_CASE("A typed number is kept within its range") {
    Driver driver;
    driver.hand.click("tab.settings");
    const auto& range = std::get<NumberSetting>(find_setting("camera.focal_length")->kind);
    driver.hand.enter("setting.camera.focal_length", "1e30");
    CHECK(driver.ui.session.a.settings.camera.focal_length == range.largest);
    driver.hand.enter("setting.camera.focal_length", "-5");
    CHECK(driver.ui.session.a.settings.camera.focal_length == range.smallest);
}

TEST_CASE("A word is chosen from a list, is marked as changed, and is reset") {
    Driver driver;
    driver.hand.click("tab.settings");
    CHECK_FALSE(driver.hand.is_visible("reset.rounding"));
    driver.hand.click("setting.rounding");
    driver.hand.click("setting.rounding=floor");
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::floor);
    driver.hand.click("reset.rounding");
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::truncate);
}

TEST_CASE("Vertices and lines are rounded in different ways, and again in one") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.click("setting.vertex_rounding");
    driver.hand.click("setting.vertex_rounding=truncate_sum");
    const Settings& settings = driver.ui.session.a.settings;
    CHECK(settings.vertex_rounding == VertexRounding::truncate_sum);
    CHECK(settings.line_rounding == Rounding::truncate);
    driver.hand.click("setting.rounding");
    driver.hand.click("setting.rounding=floor");
    CHECK(common_rounding(settings) == Rounding::floor);
}

TEST_CASE("Every setting can be reached in the panel, and the search leaves only what fits") {
    Driver driver;
    driver.hand.click("tab.settings");
    for (const Setting& setting : setting_table()) {
        INFO(setting.name);
        CHECK_NOTHROW(driver.hand.find("setting." + std::string(setting.name)));
    }
    driver.hand.enter("settings.search", "focal");
    CHECK(driver.hand.is_visible("setting.camera.focal_length"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
}

TEST_CASE("A preset's button sets what the preset names") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.click("settings.preset.exact");
    CHECK(driver.ui.session.a.settings.line_walk == LineWalk::exact);
    CHECK(common_rounding(driver.ui.session.a.settings) == Rounding::floor);
    driver.hand.click("settings.preset.handout");
    CHECK(driver.ui.session.a.settings.line_walk == LineWalk::accumulate);
}

} // namespace rasterwalk
