#include <algorithm>
#include <string>

#include "ui/actions/open_tab.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/inspector/panels.h"
#include "ui/lesson/lesson_column.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What draws a tab.
struct TabPage {
    std::string_view name;
    void (*draw)(Ui&);
};

constexpr TabPage pages[] = {
    {"vertices", draw_vertices_panel},     {"rows", draw_rows_panel},
    {"microscope", draw_microscope_panel}, {"fragment", draw_fragment_panel},
    {"history", draw_history_panel},       {"graph", draw_graph_panel},
    {"compare", draw_compare_panel},       {"lab", draw_lab_panel},
};

/// A page below this size is one of little room, design pixels.
constexpr float low_page = 330.0f;
constexpr float narrow_page = 345.0f;

/// Below this height of the inspector the groups keep their subjects to themselves, design pixels.
constexpr float low_inspector = 520.0f;

/// The tab on show; one of another name, as from a file of a later version, is the first.
const TabInfo& shown_tab(const Session& session) {
    const std::span<const TabInfo> tabs = tab_list();
    const auto found = std::find_if(tabs.begin(), tabs.end(), [&](const TabInfo& tab) {
        return tab.name == tab_below(session);
    });
    return found == tabs.end() ? tabs.front() : *found;
}

InspectorLook look_of(const Ui& ui, const Layout& layout) {
    InspectorLook look;
    look.has_lesson = layout.lesson_is_tab;
    look.has_two_lines = layout.inspector.size.y >= low_inspector * ui.options.text_scale;
    look.is_covered = is_settings_open(ui);
    const bool lesson_is_seen = look.has_lesson && ui.lesson.covers_inspector;
    if (!lesson_is_seen || look.is_covered) look.group = shown_tab(ui.session).group;
    return look;
}

/// Groups and tabs in the largest form that fits. Returns where the page begins.
float draw_head(Ui& ui, const InspectorLook& look, const Area& area) {
    const float u = ui.options.text_scale;
    if (is_compact(ImGui::GetIO().DisplaySize, ui.options)) {
        if (look.is_covered) return ImGui::GetCursorScreenPos().y; // every line counts
        return draw_tab_list(ui, look) + 2.0f * u;
    }
    const float height = group_row_height(ui, look.has_two_lines);
    draw_group_buttons(ui, look, {area.position, {area.size.x, height}});
    const float bottom = area.position.y + height + 4.0f * u;
    if (look.is_covered) return bottom + 6.0f * u;
    ImGui::SetCursorScreenPos({area.position.x + ImGui::GetStyle().WindowPadding.x, bottom});
    if (!look.group) return bottom + 5.0f * u; // the lesson has no tabs below it
    return draw_tab_line(ui, look) + 9.0f * u;
}

} // namespace

void draw_inspector(Ui& ui, const Layout& layout) {
    const Area& area = layout.inspector;
    const float u = ui.options.text_scale;
    ui.lesson.is_tab = layout.lesson_is_tab;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::Begin("inspector", nullptr, panel_flags);
    const InspectorLook look = look_of(ui, layout);
    const float top = draw_head(ui, look, area);
    ImGui::SetCursorScreenPos({area.position.x + ImGui::GetStyle().WindowPadding.x, top});
    const ImVec2 page = ImGui::GetContentRegionAvail();
    ui.inspector.is_low = page.y < low_page * u;
    ui.inspector.is_narrow = page.x < narrow_page * u;
    const std::string_view name = look.is_covered ? settings_tab
                                  : look.group    ? shown_tab(ui.session).name
                                                  : lesson_tab_name;
    // The page scrolls, its head stays.
    ImGui::BeginChild(std::string(name).c_str(), {0, 0}, false, ImGuiWindowFlags_NoNav);
    if (look.is_covered) {
        draw_settings_sheet(ui);
    } else if (!look.group) {
        draw_lesson_tab(ui);
    } else {
        const TabPage* const shown =
            std::find_if(std::begin(pages), std::end(pages),
                         [&](const TabPage& one) { return one.name == name; });
        if (shown != std::end(pages)) shown->draw(ui);
    }
    ImGui::EndChild();
    ImGui::End();
}

} // namespace rasterwalk
