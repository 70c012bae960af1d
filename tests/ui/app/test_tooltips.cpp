#include <set>

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// What needs no tooltip: the picture and the plots, with their read-outs; the borders that
/// are dragged; links and sentences; lines of a table whose headers explain them.
bool needs_tooltip(const std::string& name) {
    for (const char* exempt : {"canvas", "canvas.rows", "clip.diagram", "graph.plot",
                               "graph.carried", "fragment.none"}) {
        if (name == exempt) return false;
    }
    for (const char* exempt : {"splitter.", "lesson.link.", "lab.link.", "microscope.sample."}) {
        if (name.starts_with(exempt)) return false;
    }
    const bool is_table_row =
        name.starts_with("rows.") && name.find_first_not_of("0123456789", 5) == std::string::npos;
    return !is_table_row;
}

void collect(const Driver& driver, std::set<std::string>& bare, std::set<std::string>& seen) {
    for (const auto& [name, place] : driver.ui.widgets) {
        // An open menu's title needs none, so a widget that has had one is not checked again.
        const bool is_new = seen.insert(name).second;
        if (is_new && needs_tooltip(name) && !place.has_tooltip) bare.insert(name);
    }
}

std::string listed(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += "\n    " + name;
    return text;
}

/// Walks through all that can be opened, and collects what has no tooltip.
void walk(Driver& driver, std::set<std::string>& bare, std::set<std::string>& seen) {
    const std::vector<std::string> first = driver.hand.names();
    collect(driver, bare, seen);
    for (const std::string& name : first) {
        if (name.starts_with("menu.") || name == "canvas.view" || name == "canvas.overlays") {
            driver.hand.click(name);
            collect(driver, bare, seen);
            driver.hand.press(key::escape);
        }
    }
    for (const TabInfo& tab : tab_list()) {
        if (!is_offered(driver.ui.session, tab)) continue;
        driver.open(tab.name);
        collect(driver, bare, seen);
    }
    driver.hand.click("tab.settings");
    collect(driver, bare, seen);
    driver.hand.click("settings.close");
    for (const int sheet : {key::f1, key::f1 + 1}) {
        driver.hand.press(sheet);
        collect(driver, bare, seen);
        driver.hand.press(sheet);
    }
}

} // namespace

TEST_CASE("Every label, column and button has a tooltip") {
    std::set<std::string> bare, seen;
    {
        Driver driver;
        driver.hand.click_picture(250, 400);
        walk(driver, bare, seen);
    }
    {
        Driver driver("one-triangle.toml");
        walk(driver, bare, seen);
    }
    CHECK(seen.size() > 150);
    INFO("without a tooltip:" << listed(bare));
    CHECK(bare.empty());
}

TEST_CASE("No tooltip lies over what it explains") {
    for (const float text_scale : {1.0f, 1.5f}) {
        Driver driver("lab-room.toml", {1280, 800}, text_scale);
        driver.ui.session.selection.pixel = glm::ivec2(250, 400);
        int seen = 0;
        for (const std::string& name : driver.hand.names()) {
            const bool is_there = driver.hand.is_visible(name);
            if (!is_there || !driver.ui.widgets.at(name).has_tooltip) continue;
            driver.hand.hover(name);
            const WidgetPlace place = driver.ui.widgets.at(name); // it may have been scrolled
            // A plot or a table's page leaves no room next to it.
            if (place.bottom_right.y - place.top_left.y > 60.0f) continue;
            const ImGuiWindow* const tooltip = ImGui::FindWindowByName("##Tooltip_00");
            if (tooltip == nullptr || !tooltip->Active) continue;
            ++seen;
            INFO(name << ", text " << text_scale);
            const ImRect box = tooltip->Rect();
            const ImRect item(place.top_left, place.bottom_right);
            CHECK_FALSE(box.Overlaps(item));
            CHECK(box.Min.x >= 0.0f);
            CHECK(box.Min.y >= 0.0f);
            CHECK(box.Max.x <= 1280.5f);
            CHECK(box.Max.y <= 800.5f);
        }
        CHECK(seen > 40);
    }
}

} // namespace rasterwalk
