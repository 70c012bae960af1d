#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "pipeline/timeline.h"
#include "session/tabs.h"
#include "session/walk.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::VectorContains;

namespace rasterwalk {

namespace {

/// Text that must appear nowhere: a name not written as in a C++ program, or one that counts from
/// 1. A triangle has vertices[0] to vertices[2] and edge 0 to edge 2.
const std::regex& wrong_name() {
    static const std::regex wrong(
        "\\b([Tt]riangle|[Vv]ertex|[Ss]ample|[Ff]ragment) \\d"
        "|\\b[Ee]dge ([3-9]|\\d\\d)"
        "|\\b[Vv]ertices\\[[3-9]|\\be[3-9] \\[|\\bv[3-9]\\b"
        "|\\[(\\d+)\\] of \\3\\b"
        "|\\d\\.\\d+ ?↻|counted from 1"
        "|(^|[^+] )1 (samples|vertices|edges|triangles|fragments|pixels|rows)\\b");
    return wrong;
}

/// Collects the text on the screen outside the lesson, which has its own words.
class Looker {
  public:
    /// @param last_triangle of the scene
    explicit Looker(int last_triangle)
        : too_high_("triangles[" + next(last_triangle) + "]"),
          too_high_in_tables_("\\bt" + next(last_triangle) + "\\b") {}

    void look(const std::string& where) {
        for (const ScreenText& line : screen_text()) {
            if (line.window.starts_with("lesson") || !lines.insert(line.words).second) continue;
            const bool is_wrong = std::regex_search(line.words, wrong_name()) ||
                                  line.words.find(too_high_) != std::string::npos ||
                                  std::regex_search(line.words, too_high_in_tables_);
            if (is_wrong) FAIL_CHECK(where << ", " << line.window << ": '" << line.words << "'");
        }
    }

    bool has(const std::string& words) const {
        return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
            return line.find(words) != std::string::npos;
        });
    }

    std::set<std::string> lines;
    std::set<std::string> pointed_at; ///< names of widgets

  private:
    static std::string next(int number) { return std::to_string(number + 1); }

    std::string too_high_;
    std::regex too_high_in_tables_;
};

void rest(Driver& driver) {
    driver.hand.rest();
}

/// The beginnings of the pieces of this size, and the end.
std::vector<Cursor> moments_of(const Driver& driver, Granularity granularity) {
    const Timeline timeline(driver.ui.results.a.frame);
    std::vector<Cursor> moments{timeline.first()};
    while (moments.back() != cursor_end)
        moments.push_back(timeline.next(moments.back(), granularity));
    return moments;
}

/// All tabs at full effort; at little effort only some, different ones for each number.
std::vector<std::string_view> some_tabs(int number) {
    const std::size_t step = test::effort() < 0.5 ? 4 : 1;
    std::vector<std::string_view> all(tab_names().begin(), tab_names().end()), tabs;
    std::erase(all, hidden_tab); // not offered with a depth buffer
    std::erase(all, "file");     // only for models
    for (std::size_t i = static_cast<std::size_t>(number) % step; i < all.size(); i += step)
        tabs.push_back(all[i]);
    return tabs;
}

/// Rests the pointer on everything drawn that was not pointed at before, and reads what it says.
void read_tooltips(Driver& driver, Looker& looker, const std::string& where) {
    for (const std::string& name : driver.hand.names()) {
        const bool is_lesson = name.starts_with("lesson") || name.starts_with("menu.");
        if (is_lesson || !driver.hand.is_visible(name)) continue;
        if (!looker.pointed_at.insert(name).second) continue;
        driver.hand.hover(name);
        looker.look(where + ", pointer on " + name);
    }
    driver.hand.leave();
}

} // namespace

TEST_CASE("Text is read back from the screen") {
    Driver driver("one-triangle.toml");
    std::vector<std::string> words;
    for (const ScreenText& line : screen_text())
        words.push_back(line.words);
    CHECK_THAT(words, VectorContains(std::string("Rasterwalk")));
    CHECK_THAT(words, VectorContains(std::string("point at a pixel")));
    CHECK_THAT(words, VectorContains(std::string("triangles[0]")));
}

TEST_CASE("In the bench nothing on the screen counts from 1, at any moment and in any tab") {
    Driver driver("one-triangle.toml");
    Looker looker(0);
    set_step(driver.ui.session.a.settings, {Stage::fill});
    driver.ui.session.selection.pixel = glm::ivec2(9, 12);
    rest(driver);
    for (const std::string_view tab : tab_names()) {
        open_tab(driver.ui, std::string(tab));
        driver.ui.session.cursor = cursor_begin;
        rest(driver);
        for (const Cursor& at : test::some_of(moments_of(driver, Granularity::moment), 6)) {
            driver.ui.session.cursor = at;
            driver.hand.frames(1);
            looker.look(std::string(tab) + " at " + to_text(at));
        }
        // In the room every tooltip is read again.
        if (test::effort() >= 0.5 || tab == "rows") read_tooltips(driver, looker, std::string(tab));
    }
    open_tab(driver.ui, "rows");
    driver.ui.session.cursor = {0, Phase::edges, 1, 5};
    rest(driver);
    looker.look("half way along edge 1");
    for (const char* shown :
         {"vertices[0]", "vertices[2]", "edge 0", "edge 2", "line[4] of 11", "e1 [4]", "entry [10]",
          "fragments[0]", "triangles[0]", "x0 10", "y2 15"}) {
        INFO(shown);
        CHECK(looker.has(shown));
    }
    CHECK_FALSE(looker.has("edge 3"));
}

TEST_CASE(
    "In the room nothing on the screen counts from 1, and the last triangle is triangles[29]") {
    for (const StageInfo& stage : test::some_of(stage_list(), 3)) {
        Driver driver;
        Looker looker(29);
        set_step(driver.ui.session.a.settings, stage.step);
        driver.ui.session.selection.pixel = glm::ivec2(250, 400);
        driver.ui.session.overlays.set(Overlay::owner, true);
        driver.ui.session.overlays.set(Overlay::wireframe, true);
        driver.ui.session.overlays.set(Overlay::drawn_twice, true);
        rest(driver);
        // Among the triangles, one in the middle and the last.
        std::vector<Cursor> phases = moments_of(driver, Granularity::phase);
        std::erase_if(phases,
                      [](const Cursor& at) { return at.triangle % 15 != 14 && at != cursor_end; });
        for (const std::string_view tab : some_tabs(strip_place(stage.step))) {
            open_tab(driver.ui, std::string(tab));
            for (const Cursor& at : test::some_of(phases, 2)) {
                driver.ui.session.cursor = at;
                driver.ui.session.selection.triangle = std::nullopt;
                driver.hand.frames(2);
                looker.look(std::string(stage.name) + ", " + std::string(tab) + " at " +
                            to_text(at));
            }
        }
        CHECK(looker.has("triangles[29]"));
        driver.ui.session.selection.triangle = 29;
        open_tab(driver.ui, "vertices");
        driver.hand.frames(2);
        looker.look("the last triangle");
        CHECK(looker.has("the last of 30"));
    }
}

TEST_CASE("Tooltips, overlays and two runs count from 0 in the room") {
    Driver driver;
    Looker looker(29);
    driver.ui.session.selection.pixel = glm::ivec2(250, 400);
    driver.ui.session.overlays.set(Overlay::owner, true);
    driver.ui.session.overlays.set(Overlay::drawn_twice, true);
    rest(driver);
    for (const std::string_view tab : some_tabs(0)) {
        open_tab(driver.ui, std::string(tab));
        rest(driver);
        read_tooltips(driver, looker, std::string(tab));
    }
    Run other = driver.ui.session.a;
    other.settings.line_walk = LineWalk::multiply;
    driver.ui.session.b = other;
    open_tab(driver.ui, "compare");
    rest(driver);
    looker.look("compare");
    read_tooltips(driver, looker, "compare");
    CHECK(looker.has("of triangles["));
    CHECK(looker.has("t0 floor"));
}

TEST_CASE("A vertex on the canvas is vertices[0], or v0 where there is little room") {
    Driver driver("one-triangle.toml");
    const auto is_on_canvas = [&](const std::string& words) {
        const std::vector<ScreenText> lines = screen_text();
        return std::any_of(lines.begin(), lines.end(), [&](const ScreenText& line) {
            return line.window.starts_with("canvas") && line.words == words;
        });
    };
    CHECK(is_on_canvas("vertices[0]"));
    CHECK(is_on_canvas("vertices[2]"));
    driver.resize({800, 600});
    for (int i = 0; i < 40 && !is_on_canvas("v0"); ++i)
        driver.hand.wheel_picture(10, 5, -1.0f);
    CHECK(is_on_canvas("v0"));
    CHECK_FALSE(is_on_canvas("vertices[0]"));
}

TEST_CASE("The status line is about the whole frame, the row table about its triangle so far") {
    Driver driver("one-triangle.toml");
    driver.hand.drag_picture(10, 5, 0, 2);
    driver.hand.drag_picture(5, 10, 3, 1);
    driver.hand.drag_picture(15, 15, 3, 4);
    open_tab(driver.ui, "rows");
    driver.ui.session.cursor = cursor_begin;
    rest(driver);
    CHECK(shows_words("0 samples outside so far"));
    CHECK(shows_words("whole frame: 1 edge sample outside the row table of 1 triangle"));
    driver.ui.session.cursor = cursor_end;
    rest(driver);
    CHECK(shows_words("1 sample outside"));
    CHECK_FALSE(shows_words("so far"));
}

} // namespace rasterwalk
