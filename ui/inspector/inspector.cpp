#include <algorithm>
#include <string>

#include "ui/actions/open_tab.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What draws a tab, or the settings over the tabs.
struct TabPage {
    std::string_view name;
    void (*draw)(Ui&);
};

constexpr TabPage pages[] = {
    {"vertices", draw_vertices_panel}, {"clip", draw_clip_panel},
    {"rows", draw_rows_panel},         {"microscope", draw_microscope_panel},
    {"fragment", draw_fragment_panel}, {"texture", draw_texture_panel},
    {"hidden", draw_hidden_panel},     {"file", draw_file_panel},
    {"history", draw_history_panel},   {"graph", draw_graph_panel},
    {"compare", draw_compare_panel},   {"lab", draw_lab_panel},
    {"mine", draw_mine_panel},         {"speed", draw_speed_panel},
    {code_tab, draw_code_panel},       {settings_tab, draw_settings_sheet},
};

/// A page below this size has little room, design pixels.
constexpr float low_page = 330.0f;
constexpr float page_with_card = 430.0f; // a card has up to eleven lines
constexpr float narrow_page = 345.0f;

/// Below this height of the inspector the groups do not show their subjects, design pixels.
constexpr float low_inspector = 520.0f;

/// The tab shown; the first if the name is unknown, as from a file of a later version.
const TabInfo& shown_tab(const Session& session) {
    const std::span<const TabInfo> tabs = tab_list();
    const auto found = std::find_if(tabs.begin(), tabs.end(), [&](const TabInfo& tab) {
        return tab.name == tab_below(session);
    });
    return found == tabs.end() ? tabs.front() : *found;
}

InspectorLook look_of(const Ui& ui, const Area& area) {
    InspectorLook look;
    look.has_two_lines = area.size.y >= low_inspector * ui.options.text_scale;
    look.is_covered = is_settings_open(ui);
    look.group = shown_tab(ui.session).group;
    return look;
}

/// Groups and tabs in the largest form that fits. Returns where the page begins.
float draw_head(Ui& ui, const InspectorLook& look, const Area& area) {
    const float u = ui.options.text_scale;
    // In a lecture a head with nothing to choose is left out.
    const bool is_needed = !ui.options.is_lecture || offered_tabs(ui, std::nullopt).size() > 1;
    if (is_compact(ImGui::GetIO().DisplaySize, ui.options)) {
        // Every line counts.
        if (look.is_covered || !is_needed) return ImGui::GetCursorScreenPos().y;
        return draw_tab_list(ui) + 2.0f * u;
    }
    const float height = group_row_height(ui, look.has_two_lines);
    draw_group_buttons(ui, look, {area.position, {area.size.x, height}});
    const float bottom = area.position.y + height + 4.0f * u;
    if (look.is_covered) return bottom + 6.0f * u;
    ImGui::SetCursorScreenPos({area.position.x + ImGui::GetStyle().WindowPadding.x, bottom});
    return draw_tab_line(ui, look) + 9.0f * u;
}

} // namespace

void draw_inspector(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    // Every line counts in a low window.
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const bool is_short = area.size.y < low_page * u;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {padding.x, is_short ? 0.5f * padding.y : padding.y});
    ImGui::Begin("inspector", nullptr, panel_flags);
    ImGui::PopStyleVar();
    const InspectorLook look = look_of(ui, area);
    const float top = draw_head(ui, look, area);
    ImGui::SetCursorScreenPos({area.position.x + ImGui::GetStyle().WindowPadding.x, top});
    const ImVec2 page = ImGui::GetContentRegionAvail();
    ui.inspector.is_low = page.y < low_page * u;
    ui.inspector.has_card = page.y >= page_with_card * u;
    ui.inspector.is_narrow = page.x < narrow_page * u;
    const std::string_view name = is_settings_open(ui) ? settings_tab : shown_tab(ui.session).name;
    // The page scrolls, its head stays.
    ImGui::BeginChild(std::string(name).c_str(), {0, 0}, false, ImGuiWindowFlags_NoNav);
    const TabPage* const shown = std::find_if(std::begin(pages), std::end(pages),
                                              [&](const TabPage& one) { return one.name == name; });
    begin_line_clip();
    if (shown != std::end(pages)) shown->draw(ui);
    end_line_clip();
    ImGui::EndChild();
    ImGui::End();
}

} // namespace rasterwalk
