#include "ui/app/guard.h"

#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "base/error.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// A copy of the program's lessons that can be taken away.
class BorrowedLessons {
  public:
    BorrowedLessons() {
        std::filesystem::copy(lessons_folder(), folder_.file("lessons"),
                              std::filesystem::copy_options::recursive);
        ::setenv("RASTERWALK_LESSONS", folder_.file("lessons").c_str(), 1);
    }
    BorrowedLessons(const BorrowedLessons&) = delete;
    BorrowedLessons& operator=(const BorrowedLessons&) = delete;
    ~BorrowedLessons() { ::unsetenv("RASTERWALK_LESSONS"); }

    void take_away() const { std::filesystem::remove_all(folder_.file("lessons")); }

  private:
    test::TemporaryFolder folder_;
};

/// Opens one of everything that ImGui wants closed.
void open_everything() {
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
    ImGui::SetNextWindowSize({400, 400});
    ImGui::Begin("outer", nullptr, ImGuiWindowFlags_MenuBar);
    ImGui::GetWindowDrawList()->ChannelsSplit(2);
    ImGui::GetWindowDrawList()->ChannelsSetCurrent(1);
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0, 0, 1));
    ImGui::PushFont(ImGui::GetFont());
    ImGui::BeginMenuBar();
    ImGui::EndMenuBar();
    ImGui::BeginChild("child", {300, 300});
    ImGui::PushFont(ImGui::GetFont());
    ImGui::PushID("id");
    ImGui::BeginGroup();
    ImGui::BeginDisabled();
    ImGui::PushClipRect({0, 0}, {10, 10}, true);
    ImGui::PushItemWidth(10.0f);
    ImGui::PushTextWrapPos(10.0f);
    ImGui::SetNextItemOpen(true);
    ImGui::TreeNode("tree");
    ImGui::BeginTabBar("tabs");
    ImGui::BeginTabItem("tab");
    if (ImGui::BeginTable("table", 3)) ImGui::TableNextColumn();
    ImGui::BeginTooltip();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextItemWidth(1.0f);
}

} // namespace

TEST_CASE("A part of a frame that throws leaves ImGui as it found it, and shows its message") {
    Driver driver;
    for (int i = 0; i < 3; ++i) {
        ImGui::NewFrame();
        CHECK_FALSE(guarded(driver.ui, [] {
            open_everything();
            throw InputError("x.toml", 3, "this is wrong.");
        }));
        CHECK(driver.ui.session.notice == "x.toml:3: this is wrong.");
        CHECK_FALSE(guarded(driver.ui, [] {
            open_everything();
            throw std::bad_alloc();
        }));
        CHECK(driver.ui.session.notice == "There is not enough memory for this.");
        CHECK(guarded(driver.ui, [] {
            ImGui::Begin("good");
            ImGui::End();
        }));
        ImGui::Render(); // asserts that everything is closed
    }
    CHECK_FALSE(guarded(driver.ui, [] { throw std::runtime_error("between frames"); }));
    CHECK(driver.ui.session.notice == "between frames");
    CHECK(driver.ui.faults == 7);
    driver.hand.click("stage.depth");
    CHECK(driver.ui.session.a.settings.stage == Stage::depth);
}

TEST_CASE("If the lessons' folder disappears, the window goes on and nothing is lost") {
    const BorrowedLessons lessons;
    Driver driver;
    open_lesson(driver.ui, "05-row-table", 3);
    driver.hand.rest();
    lessons.take_away();

    driver.hand.press('S', {.ctrl = true});
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("RASTERWALK_LESSONS"));
    const Settings settings = driver.ui.session.a.settings;
    for (const char letter : {'O', 'C', 'S'}) {
        driver.hand.press(letter, {.ctrl = true});
        driver.hand.press(key::escape);
    }
    for (const int code : {key::f1, key::f1 + 1, key::page_down, key::page_up, int{'R'}, int{'L'},
                           int{'C'}, int{'N'}, int{'X'}}) {
        driver.hand.press(code);
        driver.hand.press(key::escape);
    }
    for (const std::string& name : driver.hand.names()) {
        const bool is_opener = name.starts_with("tab.") || name.starts_with("group.") ||
                               name.starts_with("menu.") || name.starts_with("lesson.") ||
                               name.starts_with("stage.");
        if (!is_opener || !driver.hand.is_visible(name)) continue;
        INFO(name);
        CHECK_NOTHROW(driver.hand.click(name));
        driver.hand.press(key::escape);
    }
    CHECK(driver.ui.lesson.progress.was_step_shown("05-row-table", 3));
    CHECK(driver.ui.session.a.settings.viewport == settings.viewport);
    driver.ui.session.a.settings.stage = Stage::points;
    driver.hand.frames(2);
    CHECK(driver.ui.results.a.frame.settings.stage == Stage::points);
}

TEST_CASE("Settings that cannot be drawn are undone, and the window goes on") {
    Driver driver;
    driver.hand.click("stage.depth");
    const Settings before = driver.ui.session.a.settings;
    // More pixels than there is memory for; no setting can ask for them.
    driver.ui.session.a.settings.viewport = {2'000'000'000, 2'000'000'000};
    driver.hand.frames(2);
    CHECK_FALSE(driver.ui.session.notice.empty());
    CHECK(driver.ui.session.a.settings == before);
    driver.hand.click("stage.rows");
    CHECK(driver.ui.session.a.settings.stage == Stage::rows);
}

} // namespace rasterwalk
