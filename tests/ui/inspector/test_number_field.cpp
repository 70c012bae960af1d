#include <string>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The text on the screen within a widget.
std::string words_in(const WidgetPlace& place) {
    std::string words;
    for (const ScreenText& line : screen_text()) {
        const float y = 0.5f * (line.low.y + line.high.y);
        const bool is_in = line.low.x >= place.top_left.x && y >= place.top_left.y &&
                           line.high.x <= place.bottom_right.x && y <= place.bottom_right.y;
        if (is_in) words += line.words;
    }
    return words;
}

} // namespace

TEST_CASE("A number in a field has the minus sign of all other numbers") {
    Driver driver;
    const std::string field = "setting.camera.position.z";
    const float& z = driver.ui.session.a.settings.camera.position.z;
    driver.hand.click("tab.settings");
    const auto shown = [&] { return words_in(driver.hand.find(field)); };
    CHECK(shown() == "−3.001");
    driver.hand.drag(field, 40.0f, 0.0f);
    CHECK(shown() == fixed(static_cast<double>(z), 3));
    REQUIRE(z < 0.0f);
    for (const char* const typed : {"-2.5", "−2.25", "1.5"}) {
        INFO(typed);
        driver.hand.enter(field, typed);
        CHECK(z == static_cast<float>(number_in(typed)));
        CHECK(shown() == fixed(static_cast<double>(z), 3));
    }
    ImGui::SetClipboardText("−1.75");
    driver.hand.click(field, {.ctrl = true});
    driver.hand.press('A', {.ctrl = true});
    driver.hand.press('V', {.ctrl = true});
    CHECK(shown() == "-1.75"); // ImGui's own while it is typed
    driver.hand.press(key::enter);
    CHECK(z == -1.75f);
    CHECK(shown() == "−1.750");
    CHECK(std::string(ImGui::GetClipboardText()) == "−1.75");
}

TEST_CASE("A vertex of the bench is shown and typed with its minus sign too") {
    Driver driver("one-triangle.toml");
    driver.open("rows");
    driver.hand.enter("bench.vertex.0.x", "−3");
    CHECK(driver.ui.session.scene->corner(0, 0).position.x == -3.0f);
    CHECK(words_in(driver.hand.find("bench.vertex.0.x")) == "x0 −3");
    // In a large window all six are on a line.
    CHECK(driver.hand.find("bench.vertex.2.y").top_left.y ==
          driver.hand.find("bench.vertex.0.x").top_left.y);
    // Whatever follows from it is written with the same sign.
    driver.hand.enter("bench.vertex.0.y", "-3");
    driver.ui.session.cursor = {0, Phase::edges, 0, 1};
    driver.hand.rest();
    REQUIRE(driver.ui.results.a.rows.last);
    REQUIRE(driver.ui.results.a.rows.last->y == -3.0f);
    int numbers = 0;
    for (const ScreenText& line : screen_text()) {
        INFO(line.words);
        CHECK(line.words.find("-3") == line.words.npos);
        numbers += line.words == "x = −3 → −3" || line.words == "y = −3 → −3" ? 1 : 0;
    }
    CHECK(numbers == 2);
}

TEST_CASE("The sides of a box are typed one by one, and set back all at once") {
    Driver driver;
    Settings& settings = driver.ui.session.a.settings;
    set_from_text(settings, "transform=matrices");
    set_from_text(settings, "near=1");
    driver.hand.click("tab.settings");
    // f = 500 shows 250 pixels to each side, which is 0.5 at the depth 1.
    CHECK(words_in(driver.hand.find("setting.view_box.right")) == "0.500");
    CHECK(words_in(driver.hand.find("setting.view_box.bottom")) == "−0.500");
    driver.hand.enter("setting.view_box.right", "0.75");
    CHECK(settings.view_box == ViewBox{-0.5f, 0.75f, -0.5f, 0.5f});
    driver.hand.enter("setting.view_box.bottom", "0");
    CHECK(settings.view_box == ViewBox{-0.5f, 0.75f, 0.0f, 0.5f});
    // Left of the left side it would be inside out.
    driver.hand.enter("setting.view_box.right", "-0.6");
    CHECK(settings.view_box == ViewBox{-0.5f, 0.75f, 0.0f, 0.5f});
    driver.hand.click("reset.view_box");
    CHECK_FALSE(settings.view_box);
}

TEST_CASE("A box's sides can be typed even if the focal length shows more or less than allowed") {
    const auto& kind = std::get<BoxSetting>(find_setting("view_box")->kind);
    struct Case {
        float focal_length, near;
        float half; ///< of each side, before one is typed
    };
    // They show 2500 and 0.0000000025 to each side.
    for (const Case& one :
         {Case{1.0f, 10.0f, kind.largest}, Case{100000.0f, 0.000001f, 0.5f * kind.least_side}}) {
        CAPTURE(one.focal_length, one.near);
        Driver driver;
        Settings& settings = driver.ui.session.a.settings;
        set_from_text(settings, "transform=matrices");
        settings.camera.focal_length = one.focal_length;
        settings.near = one.near;
        driver.hand.click("tab.settings");
        driver.hand.enter("setting.view_box.right", "500");
        CHECK(settings.view_box == ViewBox{-one.half, 500.0f, -one.half, one.half});
        driver.hand.enter("setting.view_box.bottom", "-250");
        CHECK(settings.view_box == ViewBox{-one.half, 500.0f, -250.0f, one.half});
    }
}

} // namespace rasterwalk
