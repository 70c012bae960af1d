#include "session/tabs.h"

#include <set>

#include "lessons/lesson.h"
#include "lessons/lesson_run.h"
#include "session/content.h"
#include "session/session.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "view/view_state.h"

using namespace rasterwalk;

namespace {

Session session_of_room() {
    return open_session(lessons_folder() + "/scenes/lab-room.toml");
}

void go_to_stage(Session& session, const char* stage) {
    set_from_text(session.a.settings, std::string("stage=").append(stage));
    follow_stage(session);
}

/// Every tab that the inspector offers, in order.
std::string offered(const Session& session) {
    std::string names;
    for (const TabInfo& tab : tab_list()) {
        if (is_offered(session, tab)) names.append(tab.name).append(" ");
    }
    return names;
}

const char* const steps_of_tabs = R"(<!-- lesson
title = "Tabs"
section = "Drawing points"
minutes = 1
about = "Which tab is shown."
program = "none"
scene = "scenes/lab-room.toml"
set = ["stage=fill"]
panels = ["vertices"]
-->
# Tabs

The tab that suits the stage is hidden.

## Rows

<!-- step
tab = "rows"
-->

A hidden one is named.

## Settings

<!-- step
tab = "settings"
panels = ["graph", "rows"]
-->

The settings, and other panels.

## All

<!-- step
panels = []
-->

No panel is hidden.
)";

Lesson lesson_of_tabs() {
    Lesson lesson = parse_lesson(steps_of_tabs, lessons_folder() + "/90-tabs.md");
    for (const Fault& fault : lesson.faults)
        FAIL_CHECK(fault_text(lesson, fault));
    return lesson;
}

} // namespace

TEST_CASE("The tabs of a group are together, and every tab has a different name") {
    std::set<std::string_view> names;
    std::set<TabGroup> seen;
    const TabInfo* before = nullptr;
    for (const TabInfo& tab : tab_list()) {
        CHECK(names.insert(tab.name).second);
        CHECK(find_tab(tab.name) == &tab);
        if (before == nullptr || before->group != tab.group) CHECK(seen.insert(tab.group).second);
        before = &tab;
    }
    CHECK(seen.size() == tab_group_count);
    CHECK(find_tab(settings_tab) == nullptr);
    CHECK(tab_names().size() == tab_list().size() + 1);
    for (const StageInfo& stage : stage_list())
        CHECK(find_tab(stage.tab) != nullptr);
}

TEST_CASE("The stage chooses the tab until the student does, and again when it is given back") {
    Session session = session_of_room();
    for (const StageInfo& stage : stage_list()) {
        go_to_stage(session, std::string(stage.name).c_str());
        CHECK(session.tab == stage.tab);
        CHECK_FALSE(session.tab_guide.is_own);
    }
    choose_tab(session, "graph");
    CHECK(session.tab_guide.is_own);
    go_to_stage(session, "points");
    CHECK(session.tab == "graph");
    follow_guide(session);
    CHECK(session.tab == "vertices");
    go_to_stage(session, "rows");
    CHECK(session.tab == "rows");
}

TEST_CASE("A tab that runs are compared in stays, whatever the stage") {
    Session session = session_of_room();
    for (const char* tab : {"compare", "lab"}) {
        lead_to_tab(session, tab);
        go_to_stage(session, "points");
        CHECK(session.tab == tab);
        go_to_stage(session, "pixel_light");
        CHECK(session.tab == tab);
    }
    lead_to_tab(session, "graph");
    go_to_stage(session, "points");
    CHECK(session.tab == "vertices");
}

TEST_CASE("The settings cover a tab, which is back when they are closed") {
    Session session = session_of_room();
    choose_tab(session, "graph");
    choose_tab(session, settings_tab);
    choose_tab(session, settings_tab);
    CHECK(session.tab == settings_tab);
    CHECK(tab_below(session) == "graph");
    close_settings(session);
    CHECK(session.tab == "graph");
    CHECK(session.tab_guide.is_own);
    // What is set there may change the stage, whose tab is then below.
    follow_guide(session);
    choose_tab(session, settings_tab);
    CHECK_FALSE(session.tab_guide.is_own);
    go_to_stage(session, "points");
    CHECK(session.tab == settings_tab);
    close_settings(session);
    CHECK(session.tab == "vertices");
    close_settings(session); // nothing is open
    CHECK(session.tab == "vertices");
    // If the session opens with them, as by an option, only the usual one is below.
    session = session_of_room();
    session.tab = settings_tab;
    CHECK(tab_below(session) == "fragment");
    close_settings(session);
    CHECK(session.tab == "fragment");
}

TEST_CASE("A group opens its tab that was shown last") {
    Session session = session_of_room();
    CHECK(tab_of_group(session, TabGroup::triangle) == "vertices");
    choose_tab(session, "rows");
    choose_tab(session, "history");
    CHECK(tab_of_group(session, TabGroup::triangle) == "rows");
    CHECK(tab_of_group(session, TabGroup::pixel) == "history");
    CHECK(tab_of_group(session, TabGroup::runs) == "compare");
}

TEST_CASE("A lesson's step chooses the tab until the student does; another lesson chooses again") {
    const Lesson lesson = lesson_of_tabs();
    Session session = session_of_room();
    REQUIRE(open_step(session, lesson, 1).empty());
    CHECK(session.tab == "rows");
    CHECK_FALSE(session.tab_guide.is_own);
    go_to_stage(session, "points");
    CHECK(session.tab == "rows"); // the step has named it
    choose_tab(session, "vertices");
    open_step(session, lesson, 0);
    open_step(session, lesson, 1);
    CHECK(session.tab == "vertices");
    CHECK(session.tab_guide.is_own);
    // The settings cover the student's tab, and do not take it away.
    open_step(session, lesson, 2);
    CHECK(session.tab == settings_tab);
    close_settings(session);
    CHECK(session.tab == "vertices");
    open_step(session, lesson, 1);
    CHECK(session.tab == "vertices");
    follow_guide(session);
    CHECK(session.tab == "rows");
    // Set up again, a step is as its author meant it.
    choose_tab(session, "graph");
    open_step(session, lesson, 1);
    CHECK(session.tab == "rows");
    choose_tab(session, "graph");
    Lesson other = lesson;
    other.id = "91-other";
    open_step(session, other, 1);
    CHECK(session.tab == "rows");
    CHECK_FALSE(session.tab_guide.is_own);
}

TEST_CASE("A link of a lesson leads to a tab that stays the lesson's") {
    Session session = session_of_room();
    open_step(session, lesson_of_tabs(), 1);
    choose_tab(session, "graph");
    lead_to_tab(session, "history");
    CHECK(session.tab == "history");
    CHECK_FALSE(session.tab_guide.is_own);
    CHECK(session.tab_guide.of_step == "history");
}

TEST_CASE("A step shows only the panels that it names, and never hides the one on screen") {
    const Lesson lesson = lesson_of_tabs();
    Session session = session_of_room();
    const std::string all = offered(session);
    open_step(session, lesson, 0);
    CHECK(session.tab == "vertices"); // fill would have rows, which is hidden
    CHECK(offered(session) == "vertices ");
    CHECK(tab_of_group(session, TabGroup::runs).empty());
    open_step(session, lesson, 1);
    CHECK(offered(session) == "vertices rows ");
    open_step(session, lesson, 2);
    CHECK(session.tab == settings_tab);
    CHECK(tab_below(session) == "rows");
    CHECK(offered(session) == "rows graph ");
    session.tab_guide.shows_all = true;
    CHECK(offered(session) == all);
    open_step(session, lesson, 0);
    CHECK(offered(session) == "vertices ");
    open_step(session, lesson, 3);
    CHECK(offered(session) == all);
    open_step(session, lesson, 0);
    session.lesson.clear();
    CHECK(offered(session) == all); // without a lesson nothing is hidden
}

TEST_CASE("The Hidden tab is offered where triangles are not drawn in the scene's order") {
    Session session = session_of_room();
    const auto offers_hidden = [&](const char* settings) {
        session.a.settings = default_settings(*session.scene);
        set_from_text(session.a.settings, settings);
        session.tab = "vertices";
        return is_offered(session, *find_tab(hidden_tab));
    };
    CHECK_FALSE(offers_hidden("stage=depth"));
    for (const char* const order : {"draw_order=near_first", "draw_order=far_first",
                                    "hidden=painter", "hidden=bsp", "hidden=warnock"}) {
        CAPTURE(order);
        CHECK(offers_hidden(order));
    }
    // Before stage depth no order is in force.
    session.a.settings.stage = Stage::fill;
    CHECK_FALSE(is_offered(session, *find_tab(hidden_tab)));
}

TEST_CASE("An unknown panel is refused with its line") {
    const Lesson lesson =
        parse_lesson("<!-- lesson\ntitle = \"T\"\nsection = \"Drawing points\"\n"
                     "minutes = 1\nabout = \"A.\"\nprogram = \"p\"\n"
                     "panels = [\"rows\", \"settings\", \"row\"]\n-->\n# T\n\nText.\n",
                     lessons_folder() + "/90-tabs.md");
    REQUIRE(lesson.faults.size() == 2);
    for (const Fault& fault : lesson.faults) {
        CHECK(fault.line == 7);
        CHECK_THAT(fault.sentence, Catch::Matchers::ContainsSubstring("panel"));
    }
}

TEST_CASE("A tab that a view names is the student's; one that it does not name is the stage's") {
    Session session = session_of_room();
    ViewState state;
    state.tab = "graph";
    CHECK(show_on_scene(session, state).empty());
    CHECK(session.tab == "graph");
    CHECK(session.tab_guide.is_own);
    state.tab = std::nullopt;
    set_from_text(session.a.settings, "stage=rows");
    CHECK(show_on_scene(session, state).empty());
    CHECK(session.tab == "rows");
    CHECK_FALSE(session.tab_guide.is_own);
}

TEST_CASE("A scene in pixels has no use for depth and light") {
    const Session bench = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    for (const StageInfo& info : stage_list()) {
        CHECK(is_of_use(info, *session_of_room().scene));
        CHECK(is_of_use(info, *bench.scene) == (info.step.stage <= Stage::fill));
    }
}
