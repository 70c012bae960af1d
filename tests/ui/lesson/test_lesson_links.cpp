#include "ui/actions/lesson_links.h"

#include "laboratory/bug.h"
#include "picture/view_image.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"
#include "view/widget_names.h"

namespace rasterwalk {

TEST_CASE("Each kind of link does what it says") {
    Driver driver;
    Ui& ui = driver.ui;
    const auto follow = [&](const char* target) {
        follow_link(ui, target);
        INFO(target);
        CHECK(ui.session.notice.empty());
        driver.hand.rest();
    };
    follow("set:stage=depth&interpolation=affine");
    CHECK(ui.session.a.settings.stage == Stage::depth);
    CHECK(ui.session.a.settings.interpolation == Interpolation::affine);
    follow("cursor:t3/e1/s5");
    CHECK(ui.session.cursor.triangle == 3);
    follow("cursor:end");
    CHECK(ui.session.cursor == cursor_end);
    follow("pixel:250,131");
    CHECK(ui.session.selection.pixel == glm::ivec2(250, 131));
    follow("triangle:21");
    CHECK(ui.session.selection.triangle == 21);
    follow("row:131");
    CHECK(ui.session.selection.row == 131);
    follow("vertex:1");
    CHECK(ui.session.selection.vertex == 1);
    follow("vertex:none");
    CHECK_FALSE(ui.session.selection.vertex);
    follow("tab:graph");
    CHECK(ui.session.tab == "graph");
    follow("view:depth");
    CHECK(ui.session.view == View::depth);
    follow("overlay:wireframe");
    follow("overlay:uncovered");
    CHECK(ui.session.overlays.count() == 2);
    follow("overlay:none");
    CHECK(ui.session.overlays.empty());
    follow("compare:interpolation=perspective");
    REQUIRE(ui.session.b);
    CHECK(ui.session.b->settings.interpolation == Interpolation::perspective);
    CHECK(ui.session.a.settings.interpolation == Interpolation::affine);
    follow("compare:off");
    CHECK_FALSE(ui.session.b);
    follow("preset:visible%20light");
    follow("preset:exact");
    follow("term:1/z");
    CHECK(ui.sheets.is_open(Sheet::glossary));
    CHECK(ui.sheets.search_of(Sheet::glossary) == "1/z");
    ui.sheets.show(Sheet::glossary, false);
    driver.hand.rest();
    follow("bug:B3");
    CHECK(is_on(ui.session, "B3"));
    follow("10-light-per-pixel.md");
    CHECK(ui.session.lesson == "10-light-per-pixel");
    CHECK(ui.session.step == 0);
}

TEST_CASE("A link's moment is looked for in the settings of another link in the same frame") {
    Driver driver;
    Ui& ui = driver.ui;
    const auto sets_then_goes = [&](const char* set, const char* moment) {
        follow_link(ui, set);
        follow_link(ui, moment);
        INFO(set << ", " << moment << ": " << ui.session.notice);
        const std::string notice = ui.session.notice;
        driver.hand.frames(frames_to_rest);
        return notice;
    };
    CHECK(sets_then_goes("set:stage=depth&coverage=edge_functions", "cursor:t0/b4/c7").empty());
    CHECK(ui.results.a.cursor.phase == Phase::tests);
    CHECK(ui.results.a.cursor.index == 4);
    CHECK(sets_then_goes("set:coverage=rows", "cursor:t3/e1/s5").empty());
    CHECK(ui.results.a.cursor == Cursor{3, Phase::edges, 1, 5});
    // What was there before is refused.
    CHECK_THAT(sets_then_goes("set:coverage=edge_functions", "cursor:t3/e1/s6"),
               Catch::Matchers::ContainsSubstring("walks no edges"));
}

TEST_CASE("A link that leads nowhere says so and changes nothing") {
    Driver driver;
    Ui& ui = driver.ui;
    for (const char* target :
         {"", "nothing", "set:", "set:stage", "cursor:t999", "pixel:-1,5", "triangle:30", "row:500",
          "vertex:3", "tab:row", "view:deep", "overlay:wires", "preset:exakt", "bug:B999",
          "show:switch.perspektive", "99-gone.md", "../etc/passwd", "http://example.org"}) {
        INFO(target);
        const Settings settings = ui.session.a.settings;
        const Cursor cursor = ui.session.cursor;
        ui.session.notice.clear();
        follow_link(ui, target);
        CHECK((ui.session.notice.ends_with(".") || ui.session.notice.ends_with("?")));
        CHECK(ui.session.a.settings == settings);
        CHECK(ui.session.cursor == cursor);
        CHECK(ui.session.lesson.empty());
    }
}

TEST_CASE("What a link points at is outlined until the next click or key, its tab opened") {
    Driver driver;
    Ui& ui = driver.ui;
    follow_link(ui, "show:graph.plot");
    CHECK(ui.session.tab == "graph");
    driver.hand.frames(1);
    CHECK(ui.lesson.pointed_at == "graph.plot");
    CHECK(ui.lesson.is_pinned);
    driver.hand.press('F');
    CHECK(ui.lesson.pointed_at.empty());

    follow_link(ui, "show:switch.perspective");
    driver.hand.rest();
    CHECK(ui.lesson.pointed_at == "switch.perspective");
    driver.hand.click("switch.perspective");
    CHECK(ui.lesson.pointed_at.empty());
}

TEST_CASE("The pointer on a link points without opening the tab; away from it, it ends") {
    Driver driver;
    Ui& ui = driver.ui;
    open_tab(ui, "rows");
    point_at_widget(ui, "graph.plot", false);
    ui.lesson.is_hovered = true;
    driver.hand.frames(1);
    CHECK(ui.lesson.pointed_at == "group.pixel"); // which has the tab
    CHECK(ui.session.tab == "rows");
    driver.hand.frames(1);
    CHECK(ui.lesson.pointed_at.empty());
}

TEST_CASE("A widget that is not on the screen is reported") {
    Driver driver;
    point_at_widget(driver.ui, "depth.histogram", true);
    driver.hand.frames(6);
    CHECK(driver.ui.session.notice == "What this link points to is not on the screen now.");
    CHECK(driver.ui.lesson.pointed_at.empty());
}

} // namespace rasterwalk
