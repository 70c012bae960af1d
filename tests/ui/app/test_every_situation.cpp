// One sweep over all situations of the window: nothing is cut, covered, shortened, out of the
// window, too small to be hit, without explanation or out of reach.

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "tests/ui/situations.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

using Widgets = decltype(Ui::widgets);
using Faults = std::vector<std::string>;

bool begins_with_one_of(std::string_view name, std::initializer_list<std::string_view> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view beginning) { return name.starts_with(beginning); });
}

bool is_window_of(const ScreenText& text, std::initializer_list<std::string_view> parts) {
    return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
        return text.window.find(part) != std::string::npos;
    });
}

/// Tables, plots and legends that scroll by pixels, and names of files, of which the user may have
/// any.
bool may_be_cut(const ScreenText& text, bool is_scrolled) {
    if (is_window_of(text, {"/files_", "/legend_"})) return true;
    return is_scrolled &&
           is_window_of(text, {"/rows_", "/samples_", "/history_", "/graph_", "/texture_", "/clip_",
                               "settings", "/compare_", "/speed_"});
}

/// Names of scenes, mistakes and groups, and texts of lessons are shortened where there is little
/// room.
bool may_be_short(const ScreenText& text) {
    return text.words.find("Choose a file …") != std::string::npos ||
           !is_window_of(text, {"inspector", "transport", "canvas", "legend", "status"}) ||
           is_window_of(text, {"/lab_", "/compare.groups"});
}

/// What is wrong with the text on the screen.
Faults faults_of_text(const std::vector<ScreenText>& texts, bool is_scrolled) {
    Faults faults;
    for (const ScreenText& text : texts) {
        const std::string which = text.window + ": '" + text.words + "'";
        if (text.is_cut && !may_be_cut(text, is_scrolled))
            faults.push_back(which + " is cut by an edge");
        if (text.words.find("…") != std::string::npos && !may_be_short(text))
            faults.push_back(which + " is shortened");
    }
    return faults;
}

/// A part of the other, like "rows.9.left" and "rows.9".
bool is_part_of(const std::string& name, const std::string& whole) {
    return name.starts_with(whole + ".") ||
           (whole == "depth.histogram" && name.starts_with("depth.")) ||
           (whole.starts_with("canvas") &&
            begins_with_one_of(name, {"canvas.", "outside.", "compare."}));
}

/// A button of a bar, which does not scroll.
bool is_in_bar(const std::string& name) {
    return begins_with_one_of(
               name, {"stage.", "switch.", "walk.", "step.", "tab", "group.", "scenes", "menu",
                      "canvas.fit", "canvas.grid", "canvas.overlays", "canvas.view", "canvas.zoom",
                      "canvas.shows", "lesson.whole", "lesson.next", "lesson.previous"}) &&
           !name.starts_with("menu.");
}

bool overlap(const WidgetPlace& a, const WidgetPlace& b, float tolerated) {
    const float across =
        std::min(a.bottom_right.x, b.bottom_right.x) - std::max(a.top_left.x, b.top_left.x);
    const float down =
        std::min(a.bottom_right.y, b.bottom_right.y) - std::max(a.top_left.y, b.top_left.y);
    return across > 1.5f && down > tolerated;
}

/// What is wrong with the places of the widgets.
/// @param window its size, screen pixels
Faults faults_of_places(const Widgets& widgets, ImVec2 window, float text_scale) {
    Faults faults;
    std::vector<const Widgets::value_type*> seen;
    for (const auto& widget : widgets) {
        const auto& [name, place] = widget;
        if (is_in_bar(name) && !(place.visible && place.is_whole))
            faults.push_back(name + " is not whole");
        if (!place.visible) continue;
        seen.push_back(&widget);
        const float width = place.bottom_right.x - place.top_left.x;
        const float height = place.bottom_right.y - place.top_left.y;
        if (place.top_left.x < -0.5f || place.top_left.y < -0.5f ||
            place.bottom_right.x > window.x + 0.5f || place.bottom_right.y > window.y + 0.5f)
            faults.push_back(name + " is outside the window");
        // The bars of a lesson's steps and the marks of the time line have other ways to them.
        const bool may_be_small =
            begins_with_one_of(name, {"lesson.step.", "walk.bracket", "walk.difference."});
        if (place.id != 0 && place.is_whole && !may_be_small &&
            (width < 6.0f * text_scale || height < 12.0f * text_scale))
            faults.push_back(name + " is too small to be hit");
    }
    // Lines that can be selected share the space between them.
    const float tolerated = 6.0f * text_scale;
    std::sort(seen.begin(), seen.end(), [](const auto* a, const auto* b) {
        return a->second.top_left.y < b->second.top_left.y;
    });
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const WidgetPlace& a = seen[i]->second;
        for (std::size_t j = i + 1; j < seen.size(); ++j) {
            const WidgetPlace& b = seen[j]->second;
            if (b.top_left.y > a.bottom_right.y - tolerated) break;
            const std::string &name = seen[i]->first, &other = seen[j]->first;
            if (a.part == b.part && overlap(a, b, tolerated) && !is_part_of(name, other) &&
                !is_part_of(other, name))
                faults.push_back(std::min(name, other) + " and " + std::max(name, other) +
                                 " overlap");
        }
    }
    return faults;
}

bool scrolls_down(const ImGuiWindow& window) {
    return window.Active && window.ScrollMax.y > 1.0f;
}

/// What is wrong with the parts of the window: they overlap, or one that scrolls is in another that
/// does.
Faults faults_of_parts(bool is_small) {
    Faults faults;
    std::vector<const ImGuiWindow*> parts;
    for (const ImGuiWindow* const window : GImGui->Windows) {
        const std::string_view root = window->RootWindow->Name;
        const bool is_over = (window->Flags & ImGuiWindowFlags_Popup) != 0 ||
                             (window->Flags & ImGuiWindowFlags_Tooltip) != 0 ||
                             begins_with_one_of(root, {"keys", "glossary", "###file", "splitter.",
                                                       "corner", "gear", "##"});
        if (window->Active && !window->Hidden && window->RootWindow == window && !is_over)
            parts.push_back(window);
        if (!is_small || root != "inspector" || !scrolls_down(*window)) continue;
        for (const ImGuiWindow* at = window; at != window->RootWindow; at = at->ParentWindow) {
            if (scrolls_down(*at->ParentWindow))
                faults.push_back(std::string(window->Name) + " scrolls within what scrolls");
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            ImRect inner = parts[i]->Rect();
            inner.Expand(-1.0f);
            if (inner.Overlaps(parts[j]->Rect()))
                faults.push_back(std::string(parts[i]->Name) + " lies over " + parts[j]->Name);
        }
    }
    return faults;
}

/// What needs no tooltip: the picture and the plots, with their read-outs; the borders that
/// are dragged; links and sentences; lines of a table whose headers explain them.
bool needs_tooltip(const std::string& name) {
    for (const char* exempt :
         {"canvas", "canvas.rows", "clip.diagram", "graph.plot", "graph.carried", "fragment.none",
          "graph.none", "texture.none", "canvas.outside"}) {
        if (name == exempt) return false;
    }
    if (begins_with_one_of(
            name, {"splitter.", "lesson.link.", "lesson.part", "lab.link.", "microscope.sample."}))
        return false;
    const bool is_table_row =
        name.starts_with("rows.") && name.find_first_not_of("0123456789", 5) == std::string::npos;
    return !is_table_row;
}

/// Visits situations, and keeps what is wrong and where it was first seen.
class Sweep {
  public:
    std::map<std::string, std::string> faults; ///< and the situation that has it
    std::set<std::string> bare;                ///< widgets without a tooltip
    int checked = 0;

    void visit(const Situation& situation, const std::vector<SmallWindow>& windows) {
        // Tables of two runs keep the widths of the window that they were first drawn in.
        const bool is_of_two_runs = situation.steps.find("tab:compare") != std::string::npos;
        std::optional<Driver> driver;
        for (const SmallWindow& window : windows) {
            if (is_of_two_runs) driver.reset();
            if (!driver && !open(driver, situation, window)) return;
            look_in(*driver, situation, window);
        }
    }

  private:
    bool open(std::optional<Driver>& driver, const Situation& situation,
              const SmallWindow& window) {
        driver.emplace(situation.scene, window.size, window.text_scale);
        // The theme changes nothing of this; both are drawn.
        if (checked % 2 == 1) driver->ui.options.theme = Theme::light;
        where_ = situation.scene + ": " + situation.steps;
        try {
            bring_about(*driver, situation);
        } catch (const UsageError& fault) {
            note({fault.what()});
            return false;
        }
        return true;
    }

    void note(const Faults& found) {
        for (const std::string& fault : found)
            faults.emplace(fault, where_);
    }

    void look_in(Driver& driver, const Situation& situation, const SmallWindow& window) {
        where_ = situation.scene + ": " + situation.steps + ", in " +
                 std::to_string(static_cast<int>(window.size.x)) + " x " +
                 std::to_string(static_cast<int>(window.size.y)) + " at text " +
                 std::to_string(static_cast<int>(100.0f * window.text_scale)) + " %";
        driver.ui.options.wished_text_scale = window.text_scale;
        driver.resize(window.size);
        scroll_all(driver, 0.0f);
        whole_.clear();
        if (driver.ui.canvas.place.scale <= 0.2f) note({"the picture is tiny"});
        note(faults_of_text(screen_text(), false));
        note(faults_of_parts(window.size.x < 1100.0f));
        look(driver);
        note_missing(situation.in_sight, " is not seen whole at once");
        for (const float part : {0.31f, 0.62f, 1.0f}) {
            if (scroll_all(driver, part) == 0) break;
            note(faults_of_text(screen_text(), true));
            look(driver);
        }
        for (const std::string& name : words_of_list(situation.reached)) {
            if (!whole_.contains(name) && is_whole_somewhere(driver, name)) whole_.insert(name);
        }
        note_missing(situation.reached, " is seen whole nowhere");
        ++checked;
    }

    /// Returns how many windows of the inspector scroll.
    static int scroll_all(Driver& driver, float part) {
        int count = 0;
        for (ImGuiWindow* const window : GImGui->Windows) {
            if (!scrolls_down(*window) || std::string_view(window->RootWindow->Name) != "inspector")
                continue;
            ImGui::SetScrollY(window, std::floor(part * window->ScrollMax.y));
            ++count;
        }
        driver.hand.frames(frames_to_rest);
        return count;
    }

    static bool is_whole_somewhere(Driver& driver, const std::string& name) {
        try {
            return driver.hand.find(name).is_whole;
        } catch (const UsageError&) {
            return false;
        }
    }

    void look(const Driver& driver) {
        const Widgets& widgets = driver.ui.widgets;
        note(faults_of_places(widgets, ImGui::GetIO().DisplaySize, driver.ui.options.text_scale));
        for (const auto& [name, place] : widgets) {
            if (place.visible && place.is_whole) whole_.insert(name);
            // An open menu's title needs none, so one seen with a tooltip is not looked at again.
            if (explained_.contains(name) || !needs_tooltip(name)) continue;
            if (place.has_tooltip) {
                explained_.insert(name);
                bare.erase(name);
            } else {
                bare.insert(name);
            }
        }
    }

    void note_missing(const std::string& names, const std::string& what) {
        for (const std::string& name : words_of_list(names)) {
            if (!whole_.contains(name)) note({name + what});
        }
    }

    std::string where_;
    std::set<std::string> whole_, explained_;
};

} // namespace

TEST_CASE("In every situation and window all is in sight, apart, whole, explained and in reach") {
    Sweep sweep;
    const SmallWindow large{{1600, 1000}, 1.0f};
    std::vector<SmallWindow> others{
        {{1600, 1000}, 1.5f}, {{1600, 1000}, 2.0f}, {{1366, 768}, 1.0f}};
    others.insert(others.end(), small_windows.begin(), small_windows.end());
    others.push_back({{800, 600}, 2.0f});
    std::vector<Situation> situations = workplace_situations();
    situations.insert(situations.end(), passing_situations().begin(), passing_situations().end());
    for (const Situation& situation : test::some_of(situations, 24)) {
        std::vector<SmallWindow> windows = test::some_of(others, 1);
        windows.insert(windows.begin(), large);
        sweep.visit(situation, windows);
        // At little effort the next situation is seen in the next window.
        std::rotate(others.begin(), others.begin() + 1, others.end());
    }
    for (const auto& [fault, where] : sweep.faults)
        FAIL_CHECK(fault << "\n    " << where);
    for (const std::string& name : sweep.bare)
        FAIL_CHECK(name << " has no tooltip");
    CHECK(sweep.checked >= 40);
}

TEST_CASE("What is planted in a window is found by its name") {
    Driver driver;
    driver.hand.leave();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Widgets good = driver.ui.widgets;
    REQUIRE(faults_of_places(good, window, 1.0f).empty());
    REQUIRE(faults_of_text(screen_text(), false).empty());
    const auto planted = [&](const std::function<void(WidgetPlace&)>& change) {
        Widgets bad = good;
        change(bad.at("stage.depth"));
        return faults_of_places(bad, window, 1.0f);
    };
    CHECK(planted([&](WidgetPlace& place) {
              place.bottom_right.y = -1.0f;
              place.top_left.y = -20.0f;
          }) == Faults{"stage.depth is outside the window"});
    CHECK(planted([&](WidgetPlace& place) { place.bottom_right.x = place.top_left.x + 4.0f; }) ==
          Faults{"stage.depth is too small to be hit"});
    const WidgetPlace& other = good.at("stage.rows");
    const Faults over = planted([&](WidgetPlace& place) {
        place.top_left = other.top_left;
        place.bottom_right = other.bottom_right;
    });
    CHECK(over == Faults{"stage.depth and stage.rows overlap"});
    std::vector<ScreenText> texts = screen_text();
    texts[0].is_cut = true;
    texts[0].window = texts[1].window = "inspector/vertices";
    texts[0].words = "R";
    texts[1].words = "vert…";
    CHECK(faults_of_text(texts, false) == Faults{"inspector/vertices: 'R' is cut by an edge",
                                                 "inspector/vertices: 'vert…' is shortened"});
}

} // namespace rasterwalk
