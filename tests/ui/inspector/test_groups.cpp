#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

std::string subject(Driver& driver, const char* group) {
    driver.hand.leave();
    return driver.ui.widgets.at(std::string("group.").append(group)).text;
}

bool is_there(const Driver& driver, const std::string& name) {
    return driver.ui.widgets.count(name) > 0;
}

/// The tabs that can be clicked, whichever group is shown.
int count_of_tabs(Driver& driver) {
    driver.hand.leave();
    int count = 0;
    for (const TabInfo& tab : tab_list()) {
        const std::string group = std::string("group.").append(word_of(tab.group));
        if (!is_there(driver, group)) continue;
        driver.hand.click(group);
        driver.hand.leave();
        count += is_there(driver, std::string("tab.").append(tab.name)) ? 1 : 0;
    }
    return count;
}

/// The tabs that the scene has use for.
int count_of_useful_tabs(const Driver& driver) {
    const Scene& scene = *driver.ui.session.scene;
    int count = 0;
    for (const TabInfo& tab : tab_list()) {
        const bool lacks_texture = tab.needs_maps && scene.textures.empty();
        const bool lacks_camera = tab.needs_camera && scene.space == SceneSpace::pixels;
        const bool lacks_order = tab.needs_order; // the scene's order is in force
        const bool lacks_model = tab.needs_model && !scene.model_report;
        count += lacks_texture || lacks_camera || lacks_order || lacks_model ? 0 : 1;
    }
    return count;
}

} // namespace

TEST_CASE("A group's button says what its tabs speak of, counted from 0") {
    Driver driver;
    CHECK(subject(driver, "pixel") == "none picked");
    CHECK(subject(driver, "runs") == "one run");
    follow_link(driver.ui, "triangle:7");
    CHECK(subject(driver, "triangle") == "triangles[7]");
    follow_link(driver.ui, "pixel:398,121");
    CHECK(subject(driver, "pixel") == "(398, 121)");
    driver.hand.click("switch.compare");
    CHECK(subject(driver, "runs") == "A | B");
    driver.hand.click("switch.compare");
    follow_link(driver.ui, "bug:B3");
    CHECK(subject(driver, "runs") == "B3");
}

TEST_CASE("A group opens its first tab, and later the one that was shown last") {
    Driver driver;
    CHECK(driver.ui.session.tab == "fragment"); // which suits the stage
    driver.hand.click("group.triangle");
    CHECK(driver.ui.session.tab == "vertices");
    driver.hand.click("group.pixel");
    CHECK(driver.ui.session.tab == "fragment");
    driver.hand.click("tab.graph");
    driver.hand.click("group.triangle");
    driver.hand.click("group.pixel");
    CHECK(driver.ui.session.tab == "graph");
    driver.hand.click("group.triangle");
    CHECK(driver.ui.session.tab == "vertices");
}

TEST_CASE("Every tab can be reached by its group") {
    Driver driver;
    CHECK(count_of_tabs(driver) == count_of_useful_tabs(driver));
}

TEST_CASE(
    "The stage chooses the tab until one is clicked; the link next to the tabs gives it back") {
    Driver driver;
    driver.hand.click("stage.points");
    CHECK(driver.ui.session.tab == "vertices");
    CHECK(driver.hand.is_visible("tabs.follows"));
    driver.open("rows");
    driver.hand.click("stage.depth");
    CHECK(driver.ui.session.tab == "rows");
    CHECK_FALSE(driver.hand.is_visible("tabs.follows"));
    driver.hand.click("tabs.follow");
    CHECK(driver.ui.session.tab == "history");
    driver.hand.press('1');
    CHECK(driver.ui.session.tab == "vertices");
}

TEST_CASE("The tab of a number's source counts as clicked, so the next stage leaves it alone") {
    Driver driver;
    driver.hand.click_picture(398, 121);
    follow_link(driver.ui, "tab:fragment");
    driver.hand.click("fragment.zinv");
    driver.hand.click("fragment.formula.left");
    CHECK(driver.ui.session.tab == "rows");
    CHECK(driver.ui.session.tab_guide.is_own);
}

TEST_CASE("The first lesson shows one group with one tab, and all after a click on 'show all'") {
    Driver driver;
    open_lesson(driver.ui, "01-pinhole-camera", 2);
    driver.hand.leave();
    CHECK(driver.ui.session.tab == "vertices");
    CHECK(is_there(driver, "tab.vertices"));
    for (const char* name : {"tab.rows", "tab.microscope", "group.pixel", "group.runs"}) {
        INFO(name);
        CHECK_FALSE(is_there(driver, name));
    }
    driver.hand.click("tabs.show_all");
    CHECK(count_of_tabs(driver) == count_of_useful_tabs(driver));
    driver.open("vertices");
    open_lesson(driver.ui, "01-pinhole-camera", 1);
    driver.hand.leave();
    CHECK_FALSE(is_there(driver, "group.runs"));
    open_lesson(driver.ui, "05-row-table", 0);
    CHECK_FALSE(is_there(driver, "tab.clip")); // its scene has no camera
    CHECK(count_of_tabs(driver) == count_of_useful_tabs(driver));
}

TEST_CASE("What a lesson hides is seen when a link leads there") {
    Driver driver;
    open_lesson(driver.ui, "01-pinhole-camera", 0);
    follow_link(driver.ui, "tab:history");
    driver.hand.leave();
    CHECK(is_there(driver, "group.pixel"));
    CHECK(is_there(driver, "tab.history"));
    CHECK_FALSE(is_there(driver, "tab.graph"));
    CHECK_FALSE(is_there(driver, "group.runs"));
}

TEST_CASE("A lesson that points at a panel of another group points at the group") {
    Driver driver;
    driver.open("rows");
    point_at_widget(driver.ui, "graph.plot", true);
    CHECK(driver.ui.lesson.pointed_at == "group.pixel");
    point_at_widget(driver.ui, "vertices.zinv", true);
    CHECK(driver.ui.lesson.pointed_at == "tab.vertices");
    point_at_widget(driver.ui, "tab.lab", true);
    CHECK(driver.ui.lesson.pointed_at == "group.runs");
    point_at_widget(driver.ui, "rows.copy", true);
    CHECK(driver.ui.lesson.pointed_at == "rows.copy");
    point_at_widget(driver.ui, "setting.light.power", true);
    CHECK(driver.ui.lesson.pointed_at == "tab.settings");
}

TEST_CASE("Where the lesson is a strip, its whole text takes the place of the tabs") {
    Driver driver("lab-room.toml", {1024, 640});
    open_lesson(driver.ui, "05-row-table", 2);
    driver.hand.leave();
    const auto is_text_visible = [&] {
        driver.hand.leave();
        return is_there(driver, "lesson.list");
    };
    CHECK_FALSE(is_text_visible());
    CHECK(driver.ui.session.tab == "rows");
    driver.hand.click("lesson.whole");
    CHECK(is_text_visible());
    CHECK_FALSE(is_there(driver, "rows.copy"));
    CHECK_FALSE(is_there(driver, "group.triangle"));
    driver.hand.click("lesson.whole");
    CHECK_FALSE(is_text_visible());
    CHECK(driver.ui.session.tab == "rows");
    driver.hand.click("lesson.whole");
    driver.hand.click("tab.settings");
    CHECK(driver.hand.is_visible("settings.search"));
    driver.hand.press(key::escape);
    CHECK(is_text_visible()); // what lay below
    driver.hand.click("lesson.whole");
    driver.hand.click("tab.settings");
    driver.hand.click("settings.close");
    CHECK_FALSE(is_text_visible());
    driver.hand.find("rows.copy"); // scrolls to it
    CHECK(driver.hand.is_visible("rows.copy"));
}

TEST_CASE("In the smallest window a list leads to every tab, and the gear to the settings") {
    Driver driver("lab-room.toml", {800, 600}, 1.5f);
    for (const TabInfo& tab : tab_list()) {
        if (!is_offered(driver.ui.session, tab)) continue;
        INFO(tab.name);
        driver.hand.click("tabs");
        driver.hand.click(std::string("tab.").append(tab.name));
        CHECK(driver.ui.session.tab == tab.name);
    }
    open_lesson(driver.ui, "02-moving-the-camera", 4);
    driver.hand.leave();
    CHECK(driver.ui.lesson.pointed_at == "setting.camera.position");
    CHECK(driver.hand.is_visible("settings.search"));
    driver.hand.click("tab.settings");
    CHECK_FALSE(driver.hand.is_visible("settings.search"));
    driver.hand.click("tab.settings");
    CHECK(driver.hand.is_visible("settings.search"));
}

} // namespace rasterwalk
