#include "tests/ui/driver.h"

#include "base/error.h"
#include "tests/support/catch.h"
#include "ui/hand/key_names.h"
#include "ui/hand/report.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("A click reaches the widget of that name and no other") {
    Driver driver;
    driver.hand.click("stage.points");
    CHECK(driver.ui.session.a.settings.stage == Stage::points);
    driver.hand.click("stage.edges");
    CHECK(driver.ui.session.a.settings.stage == Stage::edges);
}

TEST_CASE("A missing widget is reported with the nearest name") {
    Driver driver;
    CHECK_THROWS_WITH(
        driver.hand.click("stage.point"),
        Catch::Matchers::StartsWith("There is no widget 'stage.point' on the screen. Did you "
                                    "mean 'stage.points'? There are: stage.points, "));
}

TEST_CASE("Two clicks in one place are not a double click") {
    Driver driver;
    driver.hand.wheel_picture(250, 250, 6.0f);
    const float zoomed = driver.ui.session.canvas.zoom;
    REQUIRE(zoomed > 0.0f);
    driver.hand.click_picture(250, 250);
    driver.hand.click_picture(250, 250);
    CHECK(driver.ui.session.canvas.zoom == zoomed);
    driver.hand.double_click_picture(250, 250);
    CHECK(driver.ui.session.canvas.zoom == 0.0f); // which fits the picture again
}

TEST_CASE("Every pixel of the picture that can be seen is hit exactly") {
    Driver driver;
    for (int i = 0; i < 500; i += 7) {
        driver.hand.hover_picture(i, 499 - i);
        INFO("pixel " << i << "," << 499 - i);
        REQUIRE(driver.ui.canvas.hovered_pixel.has_value());
        REQUIRE(driver.ui.canvas.hovered_pixel->x == i);
        REQUIRE(driver.ui.canvas.hovered_pixel->y == 499 - i);
    }
}

TEST_CASE("A pixel that is not on the screen is not clicked") {
    Driver driver;
    CHECK_THROWS_AS(driver.hand.click_picture(5000, 3), UsageError);
    driver.hand.wheel_picture(250, 250, 8.0f);
    CHECK_THROWS_AS(driver.hand.click_picture(0, 0), UsageError);
    CHECK_FALSE(driver.ui.session.selection.pixel.has_value());
}

TEST_CASE("A widget that is scrolled away is scrolled into view before it is used") {
    Driver driver("lab-room.toml", {1024, 640});
    driver.hand.click("tab.settings");
    REQUIRE_FALSE(driver.hand.is_visible("setting.light.indirect"));
    const WidgetPlace place = driver.hand.find("setting.light.indirect");
    CHECK(place.visible);
    CHECK(place.bottom_right.y > place.top_left.y);
    CHECK(driver.hand.is_visible("setting.light.indirect"));
}

TEST_CASE("A key is pressed for one frame and modifiers end with it") {
    Driver driver;
    driver.hand.press('2');
    CHECK(driver.ui.session.a.settings.stage == Stage::edges);
    driver.hand.press('3', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.stage == Stage::edges);
    driver.hand.press('4');
    CHECK(driver.ui.session.a.settings.stage == Stage::fill);
}

TEST_CASE("The picture is uploaded when it has changed, and only then") {
    Driver driver;
    driver.ui.session.canvas.zoom = 1.0f; // shown as it is
    driver.hand.click("stage.points");
    const int before = driver.textures.uploads;
    CHECK(driver.textures.last == driver.ui.results.a.picture);
    driver.hand.hover("stage.depth");
    CHECK(driver.textures.uploads == before);
    driver.hand.click("stage.depth");
    CHECK(driver.textures.uploads > before);
    CHECK(driver.textures.last == driver.ui.results.a.picture);
}

TEST_CASE("The report names the settings and every widget that can be seen, with its place") {
    Driver driver;
    driver.hand.click("stage.fill");
    const std::string report = screen_report(driver.ui);
    CHECK(report.starts_with("window 1600 1000\nsetting stage fill\n"));
    CHECK(report.find("\ncursor end\n") != std::string::npos);
    const WidgetPlace place = driver.hand.find("stage.fill");
    char line[128];
    std::snprintf(line, sizeof line, "\nwidget %g %g %g %g stage.fill\n",
                  static_cast<double>(place.top_left.x), static_cast<double>(place.top_left.y),
                  static_cast<double>(place.bottom_right.x),
                  static_cast<double>(place.bottom_right.y));
    CHECK(report.find(line) != std::string::npos);
}

TEST_CASE("Keys are read by name, and an unknown name is refused") {
    CHECK(parse_key("a").key == 'A');
    CHECK(parse_key("7").key == '7');
    CHECK(parse_key("[").key == '[');
    CHECK(parse_key("F12").key == key::f12);
    CHECK(parse_key("pageup").key == key::page_up);
    const KeyPress pressed = parse_key("ctrl+Shift+Z");
    CHECK(pressed.key == 'Z');
    CHECK(pressed.modifiers.ctrl);
    CHECK(pressed.modifiers.shift);
    CHECK_FALSE(pressed.modifiers.alt);
    CHECK(parse_key("Ctrl++").key == key::equal);
    for (const char* const wrong : {"", "F13", "F0", "Ctrl+", "Hyper", "AB", "F1x", "\xc3\xa4"}) {
        INFO(wrong);
        CHECK_THROWS_AS(parse_key(wrong), UsageError);
    }
}

} // namespace rasterwalk
