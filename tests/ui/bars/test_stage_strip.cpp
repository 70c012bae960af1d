#include <algorithm>
#include <cmath>

#include "pipeline/draw.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "session/strip.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The first pixel in which two framebuffers differ, in words; empty if none does.
std::string first_difference(const Framebuffer& a, const Framebuffer& b) {
    if (a.size != b.size) return "sizes differ";
    for (int row = 0; row < a.size.height; ++row) {
        for (int column = 0; column < a.size.width; ++column) {
            const std::size_t at = a.at(column, row);
            if (a.colour[at] != b.colour[at] || a.depth[at] != b.depth[at] ||
                a.owner[at] != b.owner[at]) {
                return "pixel (" + std::to_string(column) + ", " + std::to_string(row) + ")";
            }
        }
    }
    return {};
}

Framebuffer expected_picture(const Session& session) {
    return draw_frame(prepare_frame(*session.scene, session.a.settings));
}

} // namespace

TEST_CASE("Each stage button shows its stage, in the frame in which it is clicked") {
    Driver driver;
    for (const StageInfo& info : stage_list()) {
        INFO("stage " << info.name);
        driver.hand.click("stage." + std::string(info.name));
        CHECK(step_of(driver.ui.session.a.settings) == info.step);
        CHECK(step_of(driver.ui.results.a.frame.settings) == info.step);
        CHECK(first_difference(*driver.ui.results.a.framebuffer,
                               expected_picture(driver.ui.session)) == "");
        CHECK(driver.ui.canvas.picture.number == driver.ui.results.a.picture_number);
    }
}

TEST_CASE("The digits 1 to 7 show the stages") {
    Driver driver;
    for (int i = 0; i < stage_count; ++i) {
        driver.hand.press('1' + i);
        CHECK(strip_place(step_of(driver.ui.session.a.settings)) == i);
    }
}

TEST_CASE("The perspective switch skews the light and a second click puts it right again") {
    Driver driver;
    driver.hand.click("stage.pixel_light");
    const Framebuffer right = *driver.ui.results.a.framebuffer;
    driver.hand.click("switch.perspective");
    CHECK(driver.ui.session.a.settings.interpolation == Interpolation::affine);
    CHECK(first_difference(*driver.ui.results.a.framebuffer, right) != "");
    CHECK(first_difference(*driver.ui.results.a.framebuffer, expected_picture(driver.ui.session)) ==
          "");
    driver.hand.click("switch.perspective");
    CHECK(first_difference(*driver.ui.results.a.framebuffer, right) == "");
    driver.hand.press('P');
    CHECK(driver.ui.session.a.settings.interpolation == Interpolation::affine);
}

TEST_CASE("Without the depth test the blue block covers the red one") {
    Driver driver;
    driver.hand.click("stage.depth");
    // The short block is in front of the tall one.
    const auto owner_in_front = [&] {
        const Framebuffer& f = *driver.ui.results.a.framebuffer;
        return part_name(*driver.ui.session.scene, f.owner[f.at(250, 350)]);
    };
    CHECK(owner_in_front() == "short block");
    driver.hand.click("switch.depth_test");
    CHECK(driver.ui.session.a.settings.depth_test == DepthTest::off);
    CHECK(owner_in_front() == "tall block");
    driver.hand.press('Z');
    CHECK(owner_in_front() == "short block");
}

TEST_CASE("The test that lets the farther one win is not named like a depth format next to it") {
    Driver driver;
    driver.hand.click("stage.depth");
    const auto strip_says = [&](std::string_view words) {
        driver.hand.rest();
        const auto texts = screen_text();
        return std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
            const WidgetPlace& chip = driver.hand.find("switch.depth_test");
            return text.words.find(words) != std::string::npos && text.low.y >= chip.top_left.y &&
                   text.high.y <= chip.bottom_right.y;
        });
    };
    Settings& settings = driver.ui.session.a.settings;
    settings.depth_format = DepthFormat::reversed_32;
    CHECK(strip_says("rev z"));
    driver.hand.hover("switch.depth_test");
    driver.hand.rest();
    CHECK(shows_words("reversed z, \"rev z\""));
    driver.hand.leave();
    settings.depth_test = DepthTest::reversed;
    CHECK(strip_says("farther wins"));
    CHECK_FALSE(strip_says("rev"));
}

TEST_CASE("Alternatives touch in the strip; all other buttons are set apart") {
    Driver driver;
    for (const char* const scene : {"lab-room.toml", "cylinder.toml"}) {
        set_scene(driver.ui.session, read_scene_file(lessons_folder() + "/scenes/" + scene));
        driver.hand.leave();
        const WidgetPlace* before = nullptr;
        for (const StripEntry* const entry : usable_entries(driver.ui.session)) {
            INFO(scene << ": " << entry->name);
            const WidgetPlace& place = driver.ui.widgets.at("stage." + std::string(entry->name));
            if (before != nullptr) {
                const float gap = place.top_left.x - before->bottom_right.x;
                const bool touches = entry->name == "pixel_light" ||
                                     (entry->name == "vertex_light" && scene[0] == 'c');
                CHECK((touches ? std::abs(gap) < 0.5f : gap > 10.0f));
                CHECK(place.top_left.y == before->top_left.y);
            }
            before = &place;
        }
    }
}

TEST_CASE("The strip leaves out what the scene cannot use, but never what is shown") {
    Driver driver("one-triangle.toml");
    const auto is_there = [&](const char* name) { return driver.ui.widgets.count(name) > 0; };
    CHECK(is_there("stage.fill"));
    for (const char* name : {"stage.depth", "stage.vertex_light", "stage.pixel_light",
                             "switch.perspective", "switch.depth_test"}) {
        INFO(name);
        CHECK_FALSE(is_there(name));
    }
    driver.hand.press('5');
    CHECK(driver.ui.session.a.settings.stage == Stage::depth);
    driver.hand.leave();
    CHECK(is_there("stage.depth"));
    CHECK_FALSE(is_there("stage.pixel_light"));
}

TEST_CASE("From the depth stage up, the switches are there where they change something") {
    Driver driver;
    for (const StageInfo& info : stage_list()) {
        INFO(info.name);
        driver.hand.click("stage." + std::string(info.name));
        driver.hand.leave();
        const bool matter = info.step.stage >= Stage::depth;
        CHECK((driver.ui.widgets.count("switch.perspective") > 0) == matter);
        CHECK((driver.ui.widgets.count("switch.depth_test") > 0) == matter);
        CHECK(driver.ui.widgets.count("switch.compare") > 0);
    }
}

TEST_CASE("The scene's name at the end of the strip opens the list of scenes") {
    Driver driver;
    driver.hand.click("scenes");
    driver.hand.click("scene.one-triangle");
    CHECK(driver.ui.session.scene->name == "One triangle");
    driver.hand.click("scenes");
    CHECK(driver.hand.is_visible("scene.lab-room"));
    driver.hand.press(key::escape);
    driver.hand.frames(2);
    CHECK_FALSE(driver.hand.is_visible("scene.lab-room"));
}

TEST_CASE("Where only three stages have room, a list leads to all of them") {
    Driver driver("lab-room.toml", {800, 600}, 1.5f);
    REQUIRE(driver.ui.widgets.count("stages") > 0);
    for (const StageInfo& info : stage_list()) {
        INFO(info.name);
        driver.hand.click("stages");
        driver.hand.click("stages." + std::string(info.name));
        CHECK(step_of(driver.ui.session.a.settings) == info.step);
        driver.hand.leave();
        CHECK(driver.hand.is_visible("stage." + std::string(info.name)));
    }
}

TEST_CASE("A picture is drawn again only when something changed") {
    Driver driver;
    driver.hand.click("stage.depth");
    const std::uint64_t number = driver.ui.results.a.picture_number;
    driver.hand.frames(5);
    driver.hand.hover("stage.points");
    driver.hand.click("tab.settings");
    CHECK(driver.ui.results.a.picture_number == number);
    driver.hand.click("stage.points");
    CHECK(driver.ui.results.a.picture_number > number);
}

} // namespace rasterwalk
