#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("Ten edits are undone one by one, and done again") {
    Driver driver;
    driver.hand.click("stage.depth");
    std::vector<Settings> states{driver.ui.session.a.settings};
    const char* const edits[] = {"stage.points",       "stage.rows",         "stage.pixel_light",
                                 "switch.perspective", "switch.depth_test",  "stage.fill",
                                 "stage.vertex_light", "switch.perspective", "switch.depth_test",
                                 "stage.edges"};
    for (const char* edit : edits) {
        driver.hand.click(edit);
        states.push_back(driver.ui.session.a.settings);
    }
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        driver.hand.press('Z', {.ctrl = true});
        INFO("after undoing " << edits[i - 1]);
        CHECK(driver.ui.session.a.settings == states[i - 1]);
        CHECK(driver.ui.results.a.frame.settings == states[i - 1]);
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
        driver.hand.press('Z', {.ctrl = true, .shift = true});
        INFO("after redoing " << edits[i - 1]);
        CHECK(driver.ui.session.a.settings == states[i]);
    }
}

TEST_CASE("A drag of the camera is one step to undo") {
    Driver driver;
    const Camera before = driver.ui.session.a.settings.camera;
    driver.hand.drag("canvas", 80.0f, 20.0f, {}, 1);
    CHECK_FALSE(driver.ui.session.a.settings.camera == before);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.camera == before);
}

TEST_CASE("An arrow key held on a number is one step to undo") {
    Driver driver;
    driver.hand.leave();
    driver.hand.press(key::comma, {.ctrl = true});
    driver.ui.focus.name = "setting.camera.yaw";
    driver.hand.press(key::tab);
    REQUIRE(driver.ui.focus.name == "setting.camera.yaw");
    const float before = driver.ui.session.a.settings.camera.yaw;
    const std::size_t steps = driver.ui.session.undo.past.size();
    driver.hand.press(key::right);
    const float once = driver.ui.session.a.settings.camera.yaw;
    REQUIRE(once > before);
    driver.hand.hold(key::right, 60);
    REQUIRE(driver.ui.session.a.settings.camera.yaw - once > 2.5f * (once - before));
    CHECK(driver.ui.session.undo.past.size() == steps + 2);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.camera.yaw == once);
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.camera.yaw == before);
}

TEST_CASE("Undoing a change of scene shows the whole previous scene, from outside too") {
    Driver driver;
    driver.ui.session.canvas.shows = CanvasShows::both;
    driver.hand.rest();
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.corridor");
    driver.ui.session.canvas.outside.distance = 1000.0f;
    driver.ui.session.canvas.zoom = 16.0f;
    driver.hand.rest();
    driver.hand.press('Z', {.ctrl = true});
    REQUIRE(driver.ui.session.scene->path.ends_with("lab-room.toml"));
    CHECK(driver.ui.session.canvas.outside.distance == 0.0f);
    CHECK(driver.ui.session.canvas.zoom == 0.0f);
}

TEST_CASE("Back and forward lead through the places visited") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 350);
    driver.hand.click_picture(100, 300);
    driver.hand.press(key::left, {.alt = true});
    CHECK(*driver.ui.session.selection.pixel == glm::ivec2(250, 350));
    driver.hand.press(key::left, {.alt = true});
    CHECK_FALSE(driver.ui.session.selection.pixel);
    driver.hand.press(key::right, {.alt = true});
    driver.hand.press(key::right, {.alt = true});
    CHECK(*driver.ui.session.selection.pixel == glm::ivec2(100, 300));
}

} // namespace rasterwalk
