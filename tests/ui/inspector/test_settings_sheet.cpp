#include <algorithm>
#include <set>
#include <utility>

#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/widgets.h"

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

TEST_CASE("A number of small steps is typed, shown and dragged without becoming 0") {
    Driver driver;
    driver.open("settings");
    const float& epsilon = driver.ui.session.a.settings.depth_epsilon;
    driver.hand.enter("setting.depth_epsilon", "0.0000011");
    CHECK(epsilon == 0.0000011f);
    driver.hand.drag("setting.depth_epsilon", 20.0f, 0.0f);
    CHECK(epsilon > 0.000005f);
    CHECK(epsilon < 0.00005f);
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
        const std::string name = "setting." + std::string(setting.name);
        if (is_of_use(setting, *driver.ui.session.scene, driver.ui.session.a.settings))
            CHECK_NOTHROW(driver.hand.find(name));
        else
            CHECK_FALSE(driver.hand.is_visible(name));
    }
    driver.hand.enter("settings.search", "focal");
    CHECK(driver.hand.is_visible("setting.camera.focal_length"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
    // Settings without a use in the scene are found all the same.
    driver.hand.enter("settings.search", "texture_wrap");
    CHECK(driver.hand.is_visible("setting.texture_wrap"));
}

TEST_CASE("Settings that do nothing say why, once for several, and can be set all the same") {
    Driver driver("one-triangle.toml");
    driver.ui.session.a.settings.stage = Stage::fill;
    driver.hand.click("tab.settings");
    const auto is_idle = [&](const char* first) {
        driver.hand.find("setting.spans");
        driver.hand.find("setting.coverage");
        driver.hand.leave();
        return driver.ui.widgets.count(std::string("setting_idle.") + first) > 0;
    };
    CHECK(is_idle("fill_rule"));
    CHECK_FALSE(is_idle("snap")); // it is below the other
    CHECK_FALSE(is_idle("line"));
    driver.hand.click("setting.fill_rule");
    driver.hand.click("setting.fill_rule=top_left");
    CHECK(driver.ui.session.a.settings.fill_rule == FillRule::top_left);
    driver.hand.click("setting.coverage");
    driver.hand.click("setting.coverage=edge_functions");
    CHECK_FALSE(is_idle("fill_rule"));
    CHECK(is_idle("line"));
    CHECK(is_idle("line_rounding"));
}

TEST_CASE("The wireframe is drawn by each of the four lines, as soon as it is chosen") {
    Driver driver("one-triangle.toml");
    driver.hand.click("stage.edges");
    driver.hand.click("tab.settings");
    // From (5,10) to (15,15) and from there to (10,5) every other sample lies halfway between two
    // pixels. Bresenham takes the further one, midpoint the nearer one, as seen from the start; DDA
    // rounds up, and the lab cuts down.
    struct Line {
        const char* word;
        int down, right; // which of the two rows on the first edge, of the two columns on the other
    };
    for (const Line& line : {Line{"bresenham", 1, 0}, Line{"midpoint", 0, 1}, Line{"dda", 1, 1},
                             Line{"interpolate", 0, 0}}) {
        INFO(line.word);
        driver.hand.click("setting.line");
        driver.hand.click(std::string("setting.line=") + line.word);
        std::set<std::pair<int, int>> expected, drawn;
        for (int i = 0; i <= 5; ++i)
            expected.emplace(10 - i, 5 + i);
        for (int i = 0; i <= 10; ++i) {
            expected.emplace(5 + i, 10 + (i + line.down) / 2);
            expected.emplace(10 + (i + line.right) / 2, 5 + i);
        }
        const Framebuffer& picture = *driver.ui.results.a.framebuffer;
        for (int row = 0; row < picture.size.height; ++row) {
            for (int column = 0; column < picture.size.width; ++column) {
                if (picture.owner[picture.at(column, row)] >= 0) drawn.emplace(column, row);
            }
        }
        CHECK(drawn == expected);
    }
}

TEST_CASE("The settings lie on a sheet that the gear, Escape and the cross close") {
    Driver driver;
    driver.open("rows");
    const auto is_open = [&] { return driver.hand.is_visible("settings.search"); };
    driver.hand.click("tab.settings");
    CHECK(is_open());
    CHECK_FALSE(driver.hand.is_visible("rows.copy"));
    driver.hand.press(key::escape);
    driver.hand.frames(1);
    CHECK_FALSE(is_open());
    CHECK(driver.ui.session.tab == "rows");
    driver.hand.press(key::comma, {.ctrl = true});
    CHECK(is_open());
    driver.hand.click("tab.settings");
    CHECK_FALSE(is_open());
    driver.hand.click("tab.settings");
    driver.hand.click("settings.close");
    CHECK(driver.ui.session.tab == "rows");
    // A group below the sheet is one click away.
    driver.hand.click("tab.settings");
    driver.hand.click("group.pixel");
    CHECK_FALSE(is_open());
    CHECK(driver.ui.session.tab == "fragment");
}

TEST_CASE("Escape ends the typing of a search before it closes the settings") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.click("settings.search");
    driver.hand.press(key::escape);
    driver.hand.frames(1);
    CHECK(driver.hand.is_visible("settings.search"));
    driver.hand.press(key::escape);
    driver.hand.frames(1);
    CHECK_FALSE(driver.hand.is_visible("settings.search"));
}

TEST_CASE("What differs from the handout comes first, and stays in its place while it is changed") {
    Driver driver;
    const auto top = [&](const std::string& name) {
        return driver.ui.widgets.at("setting." + name).top_left.y;
    };
    driver.hand.click("tab.settings");
    driver.hand.leave();
    REQUIRE(top("stage") < top("rounding"));
    const float before = top("rounding");
    driver.hand.click("setting.rounding");
    driver.hand.click("setting.rounding=floor");
    driver.hand.leave();
    CHECK(top("rounding") == before);
    driver.hand.press(key::escape);
    driver.hand.click("tab.settings");
    driver.hand.leave();
    CHECK(top("rounding") < top("shading"));
}

TEST_CASE("A setting that is set back stays in its place until the settings are opened again") {
    Driver driver;
    Settings& settings = driver.ui.session.a.settings;
    set_from_text(settings, "rounding=floor");
    set_from_text(settings, "spans=last_dropped");
    set_from_text(settings, "camera.yaw=0.3");
    const auto top = [&](const char* name) {
        driver.hand.leave();
        return driver.ui.widgets.at(std::string("setting.") + name).top_left.y;
    };
    driver.hand.click("tab.settings");
    const float rounding = top("rounding"), spans = top("spans"), yaw = top("camera.yaw");
    REQUIRE(std::max({rounding, spans, yaw}) < top("stage"));
    driver.hand.click("setting.rounding");
    driver.hand.click("setting.rounding=truncate"); // the default, chosen
    driver.hand.enter("setting.camera.yaw", "0");
    driver.hand.click("reset.spans");
    REQUIRE(common_rounding(settings) == Rounding::truncate);
    REQUIRE(settings.camera.yaw == 0.0f);
    CHECK(top("rounding") == rounding);
    CHECK(top("camera.yaw") == yaw);
    CHECK(top("spans") == spans);
    CHECK_FALSE(driver.hand.is_visible("reset.spans"));
    CHECK(shows_words("Changed or set back"));
    driver.hand.click("tab.settings");
    driver.hand.click("tab.settings");
    CHECK(top("rounding") > top("stage"));
    CHECK(top("spans") > top("stage"));
    CHECK_FALSE(shows_words("Changed or set back"));
}

TEST_CASE("A setting that a lesson asks for stays where it is until its next step") {
    Driver driver("lab-room.toml", {1600, 1800}); // all settings are in sight
    open_lesson(driver.ui, "02-moving-the-camera", 4);
    driver.hand.rest();
    const auto top = [&](const char* name) {
        return driver.ui.widgets.at(std::string("setting.") + name).top_left.y;
    };
    REQUIRE(top("camera.yaw") < top("stage"));
    const float before = top("camera.position"), after = top("camera.pitch");
    REQUIRE(before < after);
    REQUIRE(top("camera.yaw") < before);
    driver.hand.enter("setting.camera.position.x", "-0.887");
    driver.hand.enter("setting.camera.position.z", "-2.867");
    CHECK(top("camera.position") == before);
    CHECK(top("camera.pitch") == after);
    CHECK(driver.hand.is_visible("reset.camera.position"));
    // The next step sets the stage as well.
    driver.hand.click("lesson.next");
    REQUIRE(driver.ui.session.step == 5);
    driver.hand.press(key::comma, {.ctrl = true}); // it has its own slider, and does not need them
    CHECK(top("stage") < top("camera.yaw"));
}

TEST_CASE("Values are given in words, each in others, with their written form next to them") {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr) continue;
        std::set<std::string> said;
        for (const std::string_view word : choice->words) {
            INFO(setting.name << " = " << word);
            const std::string words = choice_words(setting, word);
            CHECK(words.find('_') == std::string::npos);
            CHECK(said.insert(words).second);
        }
    }
    Settings settings;
    CHECK(value_words(*find_setting("rounding"), settings) == "cut toward 0");
    settings.vertex_rounding = VertexRounding::floor;
    CHECK(value_words(*find_setting("rounding"), settings) == "mixed");
    CHECK(value_words(*find_setting("depth_index"), settings) == "[y][x]");
    CHECK(value_words(*find_setting("rotation"), settings) == "v R");
}

TEST_CASE("Name and value of every setting are on one line, and nothing is cut off at the side") {
    for (const auto& [window, scale] : {std::pair{ImVec2{1600, 1000}, 1.0f},
                                        {ImVec2{1600, 1000}, 1.5f},
                                        {ImVec2{1024, 640}, 1.5f},
                                        {ImVec2{800, 600}, 1.5f}}) {
        Driver driver("lab-room.toml", window, scale);
        driver.hand.click("tab.settings");
        for (const Setting& setting : setting_table()) {
            if (!is_of_use(setting, *driver.ui.session.scene, driver.ui.session.a.settings))
                continue;
            INFO(setting.name << " at " << window.x << " x " << window.y << ", text " << scale);
            const WidgetPlace field = driver.hand.find("setting." + std::string(setting.name));
            const WidgetPlace name = driver.hand.find("setting_name." + std::string(setting.name));
            CHECK(field.is_whole);
            CHECK(name.is_whole);
            CHECK(field.bottom_right.x <= window.x);
            if (scale > 1.0f) continue; // if a line is too short, a field of three is below
            if (std::holds_alternative<BoxSetting>(setting.kind)) {
                // One of four always does.
                CHECK(name.bottom_right.y <= field.top_left.y);
                continue;
            }
            CHECK(name.top_left.y >= field.top_left.y);
            CHECK(name.bottom_right.y <= field.bottom_right.y);
            CHECK(name.bottom_right.x < field.top_left.x);
        }
    }
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

TEST_CASE("Closing the settings or resetting one has no sign of failure") {
    Driver driver;
    driver.hand.click("tab.settings");
    driver.hand.click("settings.preset.exact");
    for (const ScreenText& line : screen_text()) {
        INFO(line.words);
        CHECK(line.words.find(failed_sign) == std::string::npos);
    }
    // What a preset does is next to its button.
    CHECK(shows_words("The same lab done carefully"));
}

TEST_CASE("Where there are few lines the presets share one, and what is changed is in sight") {
    for (const SmallWindow& small : small_windows) {
        INFO(small.size.x << " x " << small.size.y << ", text " << small.text_scale);
        Driver driver("lab-room.toml", small.size, small.text_scale);
        set_from_text(driver.ui.session.a.settings, "camera.yaw=-0.3");
        driver.hand.click("tab.settings");
        driver.hand.leave();
        const auto& widgets = driver.ui.widgets;
        const float first = widgets.at("settings.preset.handout").top_left.y;
        CHECK(widgets.at("settings.preset.exact").top_left.y == first);
        CHECK(widgets.at("setting.camera.yaw").is_whole);
    }
}

} // namespace rasterwalk
