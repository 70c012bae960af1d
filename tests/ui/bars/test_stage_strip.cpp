#include <catch2/catch.hpp>

#include "pipeline/draw.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

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
    // In front of the tall block stands the short one.
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
