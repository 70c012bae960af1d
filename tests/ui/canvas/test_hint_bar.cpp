// The line above the picture of a model that says what is wrong with what is seen, and mends it.

#include "ui/canvas/hint_bar.h"

#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A square that is wholly transparent.
Session clear_square() {
    const test::TemporaryFolder folder;
    folder.write("m.mtl", "newmtl m\nKd 1 1 1\nd 0\n");
    Session session;
    session.scene = std::make_shared<const Scene>(scene_of_model(read_obj(
        folder.write("m.obj", "mtllib m.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                              "f 1 2 3 4\n"))));
    session.a.settings = default_settings(*session.scene);
    return session;
}

std::string hint_of(const Driver& driver) {
    const auto place = driver.ui.widgets.find("canvas.hint");
    return place != driver.ui.widgets.end() ? place->second.text : std::string();
}

constexpr const char* transparent = "The model is transparent: nothing of it is seen";

} // namespace

TEST_CASE("A transparent model is drawn opaque at a click, and undo takes it back") {
    Driver driver(clear_square());
    driver.hand.frames(4);
    CHECK(hint_of(driver) == transparent);
    driver.hand.click("canvas.hint_act");
    driver.hand.frames(4);
    CHECK(driver.ui.session.a.settings.blend == Blend::off);
    CHECK(hint_of(driver).empty());
    driver.hand.click("corner.undo");
    driver.hand.frames(4);
    CHECK(driver.ui.session.a.settings.blend == Blend::over);
    CHECK(hint_of(driver) == transparent);
}

TEST_CASE("A hint is of the whole picture, and is hidden at a click") {
    Driver driver(clear_square());
    driver.hand.frames(4);
    REQUIRE(hint_of(driver) == transparent);
    follow_link(driver.ui, "set:stage=rows");
    driver.hand.frames(4);
    CHECK(hint_of(driver).empty());
    follow_link(driver.ui, "set:stage=depth");
    driver.hand.frames(4);
    CHECK(hint_of(driver) == transparent);
    driver.ui.session.cursor = cursor_begin;
    driver.hand.frames(4);
    CHECK(hint_of(driver).empty());
    driver.ui.session.cursor = cursor_end;
    driver.hand.frames(4);
    CHECK(hint_of(driver) == transparent);
    driver.hand.click("canvas.hint_hide");
    driver.hand.frames(4);
    CHECK(hint_of(driver).empty());
    CHECK(driver.ui.session.a.settings.blend == Blend::over);
    follow_link(driver.ui, "set:stage=shade");
    driver.hand.frames(4);
    CHECK(hint_of(driver).empty());
}

TEST_CASE("The lab's room has no hints, however dark it is") {
    Driver driver;
    follow_link(driver.ui, "set:light.power=0");
    follow_link(driver.ui, "set:light.indirect=0");
    driver.hand.frames(4);
    CHECK(hint_of(driver).empty());
}

} // namespace rasterwalk
