// What happens to a lesson when a scene is opened in its place.

#include "session/content.h"
#include "session/scene_file.h"
#include "tests/support/catch.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("A scene from the menu closes a lesson about another scene, and its tab") {
    Driver driver;
    open_lesson(driver.ui, "12-float-traps", 2);
    driver.hand.rest();
    REQUIRE(driver.ui.session.tab != Session().tab);
    REQUIRE(driver.ui.lesson.shown == "12-float-traps/2");
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.corridor");
    CHECK(driver.ui.session.scene->name == "In the corridor");
    CHECK(driver.ui.session.lesson.empty());
    CHECK(driver.ui.session.tab == usual_tab(driver.ui.session));
    CHECK_FALSE(driver.hand.is_visible("lesson.open"));
    CHECK(driver.ui.lesson.shown.find("12-float-traps") == std::string::npos);
    // The lesson is found again where it was left.
    driver.hand.click("lesson.list");
    driver.hand.click("lesson.item.12-float-traps");
    CHECK(driver.ui.session.step == 2);
}

TEST_CASE("A scene that cannot be opened leaves the lesson as it is") {
    Driver driver;
    open_lesson(driver.ui, "12-float-traps", 2);
    driver.hand.rest();
    const std::string tab = driver.ui.session.tab;
    CHECK_THROWS(open_file(driver.ui, "/nowhere/at/all.toml"));
    driver.hand.rest();
    CHECK(driver.ui.session.lesson == "12-float-traps");
    CHECK(driver.ui.session.tab == tab);
}

TEST_CASE("The Scene menu has the titles of the scenes, in their order") {
    Driver driver;
    driver.hand.click("menu.Scene");
    std::vector<std::string> shown;
    for (const SceneEntry& entry : driver.ui.scene_files) {
        const std::string title = shown_text(driver, "scene." + entry.file.stem().string());
        INFO(entry.file);
        CHECK(title == read_scene_file(entry.file.string()).name);
        shown.push_back(title);
    }
    CHECK(shown.size() > 10);
    CHECK(std::is_sorted(shown.begin(), shown.end()));
}

} // namespace rasterwalk
