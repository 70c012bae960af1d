#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "lessons/lesson_link.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "ui/actions/open_tab.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"
#include "view/widget_names.h"

namespace rasterwalk {

namespace {

/// A folder of lessons with a single note, for as long as it lives.
class OwnNote {
  public:
    explicit OwnNote(const std::string& stage, const std::string& text) {
        folder_.write("presets.toml", "preset = []\n");
        folder_.write("glossary.toml", "term = []\n");
        std::filesystem::create_directory_symlink(lessons_folder() + "/scenes",
                                                  folder_.file("scenes"));
        std::filesystem::create_directories(folder_.file("stages"));
        if (!stage.empty()) folder_.write("stages/" + stage + ".md", text);
        if (const char* before = std::getenv("RASTERWALK_LESSONS")) before_ = before;
        setenv("RASTERWALK_LESSONS", folder_.file("").c_str(), 1);
    }
    OwnNote(const OwnNote&) = delete;
    OwnNote& operator=(const OwnNote&) = delete;
    ~OwnNote() {
        if (before_.empty()) {
            unsetenv("RASTERWALK_LESSONS");
        } else {
            setenv("RASTERWALK_LESSONS", before_.c_str(), 1);
        }
    }

  private:
    test::TemporaryFolder folder_;
    std::string before_;
};

Session room_at(const StripStep& step) {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_step(session.a.settings, step);
    return session;
}

/// Where the text of the lesson's column ends on the screen.
float end_of_text() {
    float end = 1e9f;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImDrawList& list = *data->CmdLists[i];
        if (std::string_view(list._OwnerName).find("lesson.text") == std::string_view::npos)
            continue;
        for (const ImDrawCmd& command : list.CmdBuffer)
            if (command.ElemCount > 0) end = std::min(end, command.ClipRect.w);
    }
    return end;
}

float top_of(const Driver& driver, const std::string& widget) {
    return driver.ui.widgets.at(widget).top_left.y;
}

/// Follows every link of the current page by a click, each from the same start.
void follow_all(const Session& start, ImVec2 window) {
    Driver driver(start, window);
    const bool is_strip = driver.ui.widgets.count("lesson.whole") > 0;
    if (is_strip) driver.hand.click("lesson.whole");
    const std::vector<std::string> links = document_of(*driver.ui.lesson.pages.at("stage")).links;
    CHECK_FALSE(links.empty());
    for (std::size_t i = 0; i < links.size(); ++i) {
        INFO(driver.ui.lesson.shown << ": link " << i << ", " << links[i]);
        driver.ui.session = start;
        if (is_strip) {
            open_drawer(driver.ui);
        } else {
            open_tab(driver.ui, "vertices");
        }
        driver.hand.rest();
        driver.hand.click("lesson.link." + std::to_string(i));
        CHECK(driver.ui.session.notice == "");
        const LessonLink link = parse_lesson_link(links[i]);
        if (link.is_of("set")) {
            const std::size_t place = link.argument.find('=');
            const Setting* const setting = find_setting(link.argument.substr(0, place));
            REQUIRE(setting != nullptr);
            CHECK(value_text(*setting, driver.ui.session.a.settings) ==
                  link.argument.substr(place + 1));
        } else if (link.is_of("cursor")) {
            CHECK(to_text(driver.ui.results.a.cursor) == link.argument);
        } else {
            // In a narrow window perhaps the way to it: the menus are behind a button.
            const std::string shown = driver.ui.lesson.pointed_at;
            CHECK(driver.ui.lesson.meant == link.argument);
            CHECK((shown == link.argument || (is_strip && shown == "menu")));
            CHECK(driver.hand.is_visible(shown));
        }
    }
}

} // namespace

TEST_CASE("Every link of every note does what it says, in a column and in a drawer") {
    const Session bench = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    for (const ImVec2 window :
         test::some_of(std::vector{ImVec2(1024, 640), ImVec2(1600, 1000)}, 1)) {
        for (const StageInfo& info : stage_list())
            follow_all(room_at(info.step), window);
        follow_all(bench, window);
    }
}

TEST_CASE("The buttons and bars of the lesson walk through the stages") {
    Driver driver(room_at({Stage::points}));
    CHECK_FALSE(driver.hand.is_visible("lesson.previous"));
    for (int i = 1; i < stage_count; ++i) {
        driver.hand.click("lesson.next");
        CHECK(strip_place(step_of(driver.ui.session.a.settings)) == i);
    }
    CHECK_FALSE(driver.hand.is_visible("lesson.next"));
    driver.hand.click("lesson.previous");
    CHECK(step_of(driver.ui.session.a.settings) == StripStep::vertex_light);
    driver.hand.click("lesson.bar.edges");
    CHECK(driver.ui.session.a.settings.stage == Stage::edges);
}

TEST_CASE("Another page begins at its top; the same page keeps its place") {
    Driver driver(room_at({Stage::rows}), {1100, 700});
    const float top = top_of(driver, "lesson.link.0");
    driver.hand.wheel("lesson.link.0", -3.0f);
    const float scrolled = top_of(driver, "lesson.link.0");
    CHECK(scrolled < top);
    driver.hand.press('P');
    CHECK(top_of(driver, "lesson.link.0") == scrolled);
    driver.hand.click("stage.fill");
    driver.hand.click("stage.rows");
    CHECK(top_of(driver, "lesson.link.0") == top);
}

TEST_CASE("The column ends with a whole line, and with no box that has none") {
    for (const ImVec2 window : {ImVec2(1366, 768), ImVec2(1280, 720)}) {
        for (const StageInfo& info : stage_list()) {
            INFO(info.name << " at " << window.x << " x " << window.y);
            Driver driver(room_at(info.step), window);
            driver.hand.leave();
            CHECK(driver.ui.lesson.has_more_below);
            const float end = end_of_text();
            float last = 0.0f;
            for (const ScreenText& line : screen_text()) {
                if (line.window.find("lesson.text") == std::string::npos) continue;
                INFO(line.words);
                if (line.low.y < end) {
                    CHECK(line.high.y <= end + 1.0f);
                    last = std::max(last, line.high.y);
                }
            }
            CHECK(last > 0.5f * window.y);
            if (info.step != StripStep::pixel_light) continue;
            // After the last line a box begins.
            WidgetPlace below;
            below.top_left = {0.0f, last};
            below.bottom_right = {300.0f, end - 0.5f};
            const ImU32 card = packed(palette(driver.ui.options.theme).card);
            CHECK(shown_colours(below).count(card) == 0);
        }
    }
}

TEST_CASE(
    "A link that points at something outlines it while it is hovered, and stays after a click") {
    const OwnNote note("rows", "# Rows\n\n[the tab](show:tab.history)\n");
    Driver driver(room_at({Stage::rows}));
    CHECK(driver.ui.lesson.pointed_at.empty());
    driver.hand.hover("lesson.link.0");
    CHECK(driver.ui.lesson.pointed_at == "group.pixel"); // which has the tab
    driver.hand.leave();
    driver.hand.rest();
    CHECK(driver.ui.lesson.pointed_at.empty());
    driver.hand.click("lesson.link.0");
    driver.hand.leave();
    driver.hand.rest();
    CHECK(driver.ui.lesson.pointed_at == "tab.history");
    CHECK(driver.ui.session.tab == "history");
    driver.hand.press(key::period);
    CHECK(driver.ui.lesson.pointed_at.empty());
}

TEST_CASE("A link to a widget in a closed tab points at the tab, and a click opens it") {
    const OwnNote note("rows", "[power](show:setting.light.power)\n");
    Driver driver(room_at({Stage::rows}));
    driver.hand.hover("lesson.link.0");
    CHECK(driver.ui.lesson.pointed_at == "tab.settings");
    driver.hand.click("lesson.link.0");
    CHECK(driver.ui.session.tab == "settings");
    CHECK(driver.ui.lesson.pointed_at == "setting.light.power");
    CHECK(driver.ui.widgets.at("setting.light.power").visible);
}

TEST_CASE("A link that leads nowhere is answered in the status line") {
    const OwnNote note("rows", "[a](show:nothing.here) [b](foo:bar) [c](set:stage=row) [d](<>)\n");
    Driver driver(room_at({Stage::rows}));
    driver.hand.click("lesson.link.0");
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring("has no widget 'nothing.here'"));
    driver.hand.click("lesson.link.1");
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring("'foo:bar' leads nowhere"));
    driver.hand.click("lesson.link.2");
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring("stage cannot be 'row'"));
    driver.hand.click("lesson.link.3");
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("leads nowhere"));
    CHECK(driver.ui.session.a.settings.stage == Stage::rows);
}

TEST_CASE("Without its notes the program shows the stage's title and goes on") {
    const Session session = room_at({Stage::rows});
    const OwnNote note("", "");
    Driver driver(session);
    CHECK(driver.hand.is_visible("lesson.next"));
    driver.hand.click("lesson.next");
    CHECK(driver.ui.session.a.settings.stage == Stage::fill);
}

TEST_CASE("The largest page is drawn and scrolled") {
    std::string text;
    // Under sanitizers a megabyte takes a quarter of a minute.
    const std::size_t size = static_cast<std::size_t>(test::rounds(int{largest_markdown}, 100'000));
    while (text.size() + 40 < size)
        text += "word [link](set:stage=rows) `code`\n\n";
    const Session session = room_at({Stage::rows});
    const OwnNote note("rows", text);
    Driver driver(session);
    CHECK(driver.ui.widgets.at("lesson.link.0").visible);
    driver.hand.wheel("lesson.link.0", -200.0f);
    CHECK_FALSE(driver.hand.is_visible("lesson.link.0"));
    CHECK(driver.hand.is_visible("lesson.next"));
}

TEST_CASE("The page about the depth buffer speaks of the picked pixel, in every scene") {
    for (const char* const scene : {"lab-room.toml", "corridor.toml"}) {
        INFO(scene);
        Driver driver(scene);
        driver.hand.press('5');
        driver.hand.leave();
        REQUIRE(driver.ui.session.page != SidePage::list);
        CHECK_FALSE(shows_words("400)"));
        CHECK_FALSE(shows_words("in all, of which"));
        const glm::ivec2 pixel{90, 120};
        driver.ui.session.selection.pixel = pixel;
        driver.hand.rest();
        REQUIRE(driver.ui.results.history);
        CHECK(shows_words("120)"));
        CHECK_FALSE(shows_words("{"));
    }
}

} // namespace rasterwalk
