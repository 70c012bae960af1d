// The diagram of the Clip tab: what is where in it, and what a click on a corner asks.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "inspect/clip_diagram.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// A triangle of the corridor in the Clip tab, cut by all planes.
struct CutWall {
    Driver driver;

    explicit CutWall(int triangle, ImVec2 window = {1600, 1000}, float text_scale = 1.0f)
        : driver("corridor.toml", window, text_scale) {
        follow_link(driver.ui, "set:clip=all");
        follow_link(driver.ui, "triangle:" + std::to_string(triangle));
        driver.hand.rest();
        driver.open("clip");
    }
    const ClipHistory& history() const { return *driver.ui.results.a.inspected.clip; }
};

ImVec2 middle_of(const WidgetPlace& place) {
    return {0.5f * (place.top_left.x + place.bottom_right.x),
            0.5f * (place.top_left.y + place.bottom_right.y)};
}

/// All text in the window.
std::string words_on_screen() {
    std::string words;
    for (const ScreenText& text : screen_text(8.0f))
        words += text.words + "\n";
    return words;
}

/// How many triangles are seen below this widget, no wider than it, in its own window.
int seen_below(const WidgetPlace& place) {
    int seen = 0;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImDrawList& list = *data->CmdLists[i];
        if (std::string(list._OwnerName).find("clip.page") == std::string::npos) continue;
        for (const ImDrawCmd& command : list.CmdBuffer) {
            for (unsigned k = 0; k + 2 < command.ElemCount; k += 3) {
                float low = 1e9f, high = -1e9f, left = 1e9f, right = -1e9f;
                for (unsigned corner = 0; corner < 3; ++corner) {
                    const auto index =
                        list.IdxBuffer[static_cast<int>(command.IdxOffset + k + corner)];
                    const ImVec2 at =
                        list.VtxBuffer[static_cast<int>(command.VtxOffset) + index].pos;
                    low = std::min(low, at.y);
                    high = std::max(high, at.y);
                    left = std::min(left, at.x);
                    right = std::max(right, at.x);
                }
                const bool is_beside =
                    right > place.bottom_right.x + 1.0f || left < place.top_left.x - 1.0f;
                const float end = std::min(high, command.ClipRect.w);
                const bool is_below = std::max(low, command.ClipRect.y) < end - 0.01f &&
                                      end > place.bottom_right.y + 1.0f;
                seen += !is_beside && is_below ? 1 : 0;
            }
        }
    }
    return seen;
}

} // namespace

TEST_CASE("The diagram of the Clip tab has w upward and the plane's coordinate to the right") {
    for (const int triangle : {0, 1, 5}) {
        CutWall wall(triangle);
        Driver& driver = wall.driver;
        REQUIRE_FALSE(wall.history().planes.empty());
        CAPTURE(triangle);
        CHECK(driver.hand.find("clip.diagram").is_whole);
        const auto diagram = clip_diagram(wall.history(), wall.history().planes.front().plane);
        REQUIRE(diagram);
        int compared = 0;
        for (std::size_t i = 0; i < diagram->corners.size(); ++i) {
            for (std::size_t j = 0; j < diagram->corners.size(); ++j) {
                const std::string a = fmt::format("clip.diagram.corner.{}", i);
                const std::string b = fmt::format("clip.diagram.corner.{}", j);
                if (driver.ui.widgets.count(a) == 0 || driver.ui.widgets.count(b) == 0) continue;
                const ImVec2 at_a = middle_of(driver.ui.widgets.at(a));
                const ImVec2 at_b = middle_of(driver.ui.widgets.at(b));
                const glm::dvec2 place_a = diagram->place(diagram->corners[i]);
                const glm::dvec2 place_b = diagram->place(diagram->corners[j]);
                CAPTURE(a, b);
                if (place_a.y > place_b.y) CHECK(at_a.y < at_b.y);
                if (place_a.x > place_b.x) CHECK(at_a.x > at_b.x);
                ++compared;
            }
        }
        CHECK(compared >= 4);
    }
}

TEST_CASE("A corner of the diagram shows its coordinates, and a click explains its distance") {
    CutWall wall(0);
    Driver& driver = wall.driver;
    driver.hand.click("clip.diagram.corner.0");
    CHECK(driver.ui.inspector.clip.number == "d.0.0");
    driver.hand.find("clip.diagram");
    driver.hand.hover("clip.diagram.corner.0");
    driver.hand.rest();
    // -160, 160, 1, -2: behind the camera, 2.1 beyond the near plane.
    const std::string words = words_on_screen();
    CHECK_THAT(words, Catch::Matchers::ContainsSubstring("w = −2.000"));
    CHECK_THAT(words, Catch::Matchers::ContainsSubstring("d = −2.100"));
    driver.hand.leave();
    driver.hand.click("clip.diagram.new.0");
    CHECK(driver.ui.inspector.clip.number == "t.0.0");
}

TEST_CASE("The diagram follows the plane at work, with t at the edge that it has just cut") {
    CutWall wall(0);
    Driver& driver = wall.driver;
    const auto plane_above = [&] {
        // The diagram is below the table of its plane.
        const float diagram = driver.ui.widgets.at("clip.diagram").top_left.y;
        int plane = -1;
        for (const PlaneHistory& work : wall.history().planes) {
            const std::string edge = fmt::format("clip.edge.{}.0", static_cast<int>(work.plane));
            if (driver.ui.widgets.at(edge).top_left.y < diagram)
                plane = static_cast<int>(work.plane);
        }
        return plane;
    };
    REQUIRE(wall.history().planes.size() >= 2);
    const std::vector<PlaneHistory> planes = wall.history().planes;
    for (const PlaneHistory& work : planes) {
        const int plane = static_cast<int>(work.plane);
        for (const ClipStep& step : work.steps) {
            if (!step.is_cut) continue;
            driver.hand.click(fmt::format("clip.edge.{}.{}", plane, step.from));
            driver.hand.find("clip.diagram");
            driver.hand.leave();
            driver.hand.rest();
            CAPTURE(plane, step.from);
            CHECK(plane_above() == plane);
            CHECK_THAT(words_on_screen(), Catch::Matchers::ContainsSubstring(fmt::format(
                                              "t = {:.4f}", static_cast<double>(step.t))));
        }
    }
}

TEST_CASE("A plane that is opened has the diagram") {
    CutWall wall(5);
    Driver& driver = wall.driver;
    REQUIRE(work_of(wall.history(), ClipPlane::far) == nullptr);
    driver.hand.click("clip.plane.far");
    driver.hand.find("clip.diagram");
    CHECK(driver.ui.widgets.at("clip.diagram").top_left.y >
          driver.ui.widgets.at("clip.edge.1.0").top_left.y);
    CHECK(driver.ui.widgets.at("clip.diagram").top_left.y <
          driver.ui.widgets.at("clip.edge.2.0").top_left.y);
    driver.hand.click("clip.plane.far");
    driver.hand.find("clip.diagram");
    CHECK(driver.ui.widgets.at("clip.diagram").top_left.y <
          driver.ui.widgets.at("clip.edge.2.0").top_left.y);
}

TEST_CASE(
    "No name of a line in the diagram lies over an edge, even where near plane and eye meet") {
    int named = 0;
    for (const int triangle : {0, 1, 5, 9}) {
        CutWall wall(triangle);
        Driver& driver = wall.driver;
        for (const char* near : {"near=0.01", "near=0.1", "near=1"}) {
            follow_link(driver.ui, std::string("set:") + near);
            driver.hand.leave();
            if (wall.history().planes.empty()) continue;
            const WidgetPlace area = driver.hand.find("clip.diagram");
            std::vector<ImVec2> corners;
            for (int i = 0; driver.ui.widgets.count(fmt::format("clip.diagram.corner.{}", i)) > 0;
                 ++i)
                corners.push_back(
                    middle_of(driver.ui.widgets.at(fmt::format("clip.diagram.corner.{}", i))));
            for (const ScreenText& text : screen_text()) {
                const bool is_of_line =
                    text.words.starts_with("w = 0") || text.words.ends_with(" plane");
                if (!is_of_line || text.low.y < area.top_left.y ||
                    text.high.y > area.bottom_right.y || text.low.x < area.top_left.x)
                    continue;
                ++named;
                CAPTURE(triangle, near, text.words);
                // Corners in one place have one mark, and then not all edges are known here.
                for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
                    for (int k = 0; k <= 400; ++k) {
                        const float s = static_cast<float>(k) / 400.0f;
                        const ImVec2 &a = corners[i], &b = corners[i + 1];
                        const ImVec2 at{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
                        const bool is_over = at.x > text.low.x && at.x < text.high.x &&
                                             at.y > text.low.y && at.y < text.high.y;
                        if (is_over) FAIL("an edge runs through it");
                    }
                }
            }
        }
    }
    CHECK(named > 6);
}

TEST_CASE("A table without room leaves no line below the diagram") {
    Driver driver("corridor.toml");
    follow_link(driver.ui, "set:clip=near");
    follow_link(driver.ui, "tab:clip");
    driver.hand.frames(frames_to_rest);
    follow_link(driver.ui, "cursor:t0/p0/s2");
    driver.hand.frames(2 * frames_to_rest);
    const WidgetPlace diagram = driver.ui.widgets.at("clip.diagram");
    REQUIRE(diagram.is_whole);
    // The table of the corner that the plane has made comes next; the card of t takes its room.
    REQUIRE_FALSE(driver.hand.is_visible("clip.new.1"));
    CHECK(seen_below(diagram) == 0);
}

TEST_CASE("In a small window the diagram of the Clip tab is whole, or is not there") {
    std::vector<SmallWindow> windows(small_windows.begin(), small_windows.end());
    windows.push_back({{1280, 720}, 1.0f});
    windows.push_back({{1366, 768}, 1.25f});
    windows.push_back({{1600, 1000}, 2.0f});
    for (const SmallWindow& window : windows) {
        CAPTURE(window.size.x, window.size.y, window.text_scale);
        CutWall wall(5, window.size, window.text_scale);
        Driver& driver = wall.driver;
        CHECK(driver.hand.find("clip.plane.near").is_whole);
        if (driver.ui.widgets.count("clip.diagram") == 0) continue;
        CHECK(driver.hand.find("clip.diagram").is_whole);
    }
}

} // namespace rasterwalk
