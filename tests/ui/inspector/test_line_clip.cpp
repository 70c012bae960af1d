// What scrolls in the inspector begins and ends with whole lines.

#include <algorithm>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The part of a window that is drawn.
struct Edges {
    float top = -1e9f, bottom = 1e9f; ///< screen pixels
};

Edges edges_of(const ImDrawList& list) {
    Edges edges;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.ElemCount == 0) continue;
        edges.top = std::max(edges.top, command.ClipRect.y);
        edges.bottom = std::min(edges.bottom, command.ClipRect.w);
    }
    return edges;
}

/// The windows of the inspector that scroll; tables that scroll have their own lines.
std::vector<ImGuiWindow*> scrolling_windows() {
    std::vector<ImGuiWindow*> windows;
    for (ImGuiWindow* const window : GImGui->Windows) {
        const bool is_table = std::string(window->Name).find("compare.groups") != std::string::npos;
        if (window->Active && window->ScrollMax.y > 0.0f && !is_table &&
            std::string(window->RootWindow->Name) == "inspector") {
            windows.push_back(window);
        }
    }
    return windows;
}

/// Lines of text that an edge cuts through.
std::vector<std::string> cut_lines(const ImGuiWindow& window) {
    const Edges edges = edges_of(*window.DrawList);
    std::vector<std::string> cut;
    for (const ScreenText& line : screen_text()) {
        if (line.window != window.DrawList->_OwnerName) continue;
        const bool is_seen = line.low.y < edges.bottom - 1.0f && line.high.y > edges.top + 1.0f;
        if (is_seen && (line.high.y > edges.bottom + 1.5f || line.low.y < edges.top - 1.5f))
            cut.push_back(line.words);
    }
    return cut;
}

/// Scrolls everything in the inspector to several places, and looks at the edges there.
/// Returns in how many places something was seen to scroll.
int look_at_edges(Driver& driver) {
    int checked = 0;
    for (const float part : {0.0f, 0.13f, 0.31f, 0.47f, 0.62f, 0.88f, 1.0f}) {
        for (ImGuiWindow* const window : scrolling_windows())
            ImGui::SetScrollY(window, part * window->ScrollMax.y);
        driver.hand.frames(2);
        for (const ImGuiWindow* const window : scrolling_windows()) {
            INFO(window->Name << " scrolled by " << window->Scroll.y);
            CHECK(cut_lines(*window) == std::vector<std::string>{});
            ++checked;
        }
    }
    return checked;
}

} // namespace

TEST_CASE("The Compare tab begins and ends with whole lines") {
    for (const SmallWindow& window : test::some_of(all_windows(), 3)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.tab = "compare";
        driver.hand.frames(frames_to_rest + 2);
        look_at_edges(driver);
        toggle_compare(driver.ui);
        driver.hand.frames(frames_to_rest + 2);
        CHECK(look_at_edges(driver) > 3);
    }
}

TEST_CASE("The row table ends with a whole row") {
    for (const ImVec2 size :
         {ImVec2(1280, 720), ImVec2(1366, 768), ImVec2(1600, 1000), ImVec2(1600, 933)}) {
        INFO(size.x << " x " << size.y);
        Driver driver("lab-room.toml", size);
        driver.ui.session.selection.triangle = 7;
        driver.ui.session.tab = "rows";
        driver.hand.frames(frames_to_rest + 2);
        int rows = 0;
        for (const ImGuiWindow* const window : scrolling_windows()) {
            const float bottom = window->InnerClipRect.Max.y;
            for (const ScreenText& line : screen_text()) {
                if (line.window != window->DrawList->_OwnerName || line.low.y > bottom - 1.0f)
                    continue;
                INFO(line.words);
                CHECK(line.high.y <= bottom + 1.5f);
                ++rows;
            }
        }
        CHECK(rows > 10);
    }
}

TEST_CASE("In a small window the samples of an edge begin and end with whole lines") {
    for (const ImVec2 size : {ImVec2(1024, 640), ImVec2(800, 600)}) {
        INFO(size.x << " x " << size.y);
        Driver driver("lab-room.toml", size, 1.5f);
        driver.ui.session.selection.triangle = 7;
        driver.ui.session.tab = "microscope";
        driver.hand.frames(frames_to_rest + 2);
        CHECK(look_at_edges(driver) > 3);
    }
}

TEST_CASE("In a small window small pictures of coverage begin and end with whole lines") {
    for (const bool has_test : {true, false}) {
        Driver driver("dented.toml", {1024, 640}, 1.5f);
        driver.ui.session.a.settings.coverage = Coverage::edge_functions;
        driver.ui.session.selection.triangle = 0;
        if (has_test) driver.ui.session.selection.pixel = {4, 11};
        driver.ui.session.tab = "rows";
        driver.hand.frames(frames_to_rest + 2);
        CHECK(look_at_edges(driver) > 3);
    }
}

TEST_CASE("A title of the Clip tab is above a row of its table, or is not seen") {
    const std::vector<std::string> titles{"The corners", "Outcodes",  "near plane",
                                          "left plane",  "top plane", "The polygon that remains"};
    int checked = 0;
    for (float height = 800.0f; height <= 1020.0f; height += 20.0f) {
        INFO("window 1600 x " << height);
        Driver driver("corridor.toml", {1600, height});
        driver.ui.session.a.settings.clip = Clip::all;
        driver.ui.session.selection.triangle = 5;
        driver.ui.session.tab = "clip";
        driver.hand.frames(frames_to_rest + 2);
        for (const ImGuiWindow* const window : scrolling_windows()) {
            const Edges edges = edges_of(*window->DrawList);
            std::vector<ScreenText> seen;
            for (const ScreenText& line : screen_text()) {
                if (line.window == window->DrawList->_OwnerName &&
                    line.high.y <= edges.bottom + 1.5f)
                    seen.push_back(line);
            }
            for (const ScreenText& title : seen) {
                if (std::find(titles.begin(), titles.end(), title.words) == titles.end()) continue;
                INFO(title.words);
                // Below it are the titles of the columns and at least one row.
                const float lines_below = 2.0f * title.size;
                CHECK(std::any_of(seen.begin(), seen.end(), [&](const ScreenText& line) {
                    return line.low.y > title.low.y + lines_below;
                }));
                ++checked;
            }
        }
    }
    CHECK(checked > 20);
}

TEST_CASE("Below a page that scrolls its card follows the last whole line, and both keep still") {
    int checked = 0;
    for (float height = 860.0f; height <= 1020.0f; height += 20.0f) {
        for (const bool is_closed : {false, true}) {
            INFO("window 1600 x " << height << (is_closed ? ", no plane is open" : ""));
            Driver driver("corridor.toml", {1600, height});
            driver.ui.session.a.settings.clip = Clip::all;
            driver.ui.session.selection.triangle = 5;
            driver.ui.session.tab = "clip";
            driver.hand.rest();
            if (is_closed) {
                for (const char* const plane : {"near", "left", "top"})
                    driver.hand.click(std::string("clip.plane.") + plane);
            }
            driver.hand.frames(frames_to_rest + 2);
            if (scrolling_windows().size() != 1) continue;
            ImGuiWindow* const page = scrolling_windows().front();
            ImGui::SetScrollY(page, 0.0f);
            driver.hand.frames(frames_to_rest + 2);
            const float end = page->Pos.y + page->Size.y;
            float last = 0.0f;
            for (const ScreenText& line : screen_text()) {
                if (line.window == page->DrawList->_OwnerName && line.high.y <= end + 1.5f)
                    last = std::max(last, line.high.y);
            }
            // Between the two is a gap, and no blank strip.
            const float card = driver.ui.widgets.at("clip.formula").top_left.y;
            CHECK(card > last);
            CHECK(card - last < 60.0f);
            // Whatever is scrolled, and in whichever frame.
            for (const float part : {0.0f, 0.4f, 1.0f, 0.0f}) {
                ImGui::SetScrollY(page, part * page->ScrollMax.y);
                for (int frame = 0; frame < 4; ++frame) {
                    driver.hand.frames(1);
                    CHECK(driver.ui.widgets.at("clip.formula").top_left.y == card);
                }
            }
            ++checked;
        }
    }
    CHECK(checked > 10);
}

} // namespace rasterwalk
