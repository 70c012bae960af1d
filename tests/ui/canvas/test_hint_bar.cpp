// The line above the picture of a model that says what is wrong with it, and fixes it.

#include "ui/canvas/hint_bar.h"

#include <memory>
#include <utility>

#include "support/hinted_models.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

Session session_of_model(Scene scene) {
    Session session;
    session.scene = std::make_shared<const Scene>(std::move(scene));
    session.a.settings = default_settings(*session.scene);
    return session;
}

Session clear_sheet() {
    return session_of_model(test::sheet_of("Kd 1 1 1\nd 0\n"));
}

std::string hint_of(const Driver& driver) {
    const auto place = driver.ui.widgets.find("canvas.hint");
    return place != driver.ui.widgets.end() ? place->second.text : std::string();
}

constexpr const char* transparent = "The model is transparent, so you cannot see it";

} // namespace

TEST_CASE("A transparent model is drawn opaque at a click, and undo takes it back") {
    Driver driver(clear_sheet());
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

TEST_CASE("A hint is about the whole picture, and a click hides it") {
    Driver driver(clear_sheet());
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

TEST_CASE("A scene that is not a model has no hint, whatever is seen of it") {
    Scene scene = test::sheet_of("Kd 1 1 1\nd 0\n");
    scene.model_report.reset();
    Driver driver(session_of_model(std::move(scene)));
    driver.hand.frames(6);
    CHECK_FALSE(is_working(driver.ui.results));
    CHECK(hint_of(driver).empty());
}

} // namespace rasterwalk
