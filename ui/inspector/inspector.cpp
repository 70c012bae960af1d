#include <string>
#include <vector>

#include "ui/actions/open_tab.h"
#include "ui/inspector/panels.h"
#include "ui/lesson/lesson_column.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

struct Tab {
    const char* name;
    const char* title;
    const char* help;
    void (*draw)(Ui&);
};

const Tab lesson_tab{"lesson", "Lesson",
                     "The lesson, the page about this stage, or the list of lessons.",
                     draw_lesson_tab};
const Tab tabs[] = {
    {"vertices", "Vertices", "The corners of the triangle in every space on their way to a pixel.",
     draw_vertices_panel},
    {"rows", "Rows", "The triangle's row table: leftPixels and rightPixels.", draw_rows_panel},
    {"fragment", "Fragment", "Every number on a fragment's way to its colour, with its formula.",
     draw_fragment_panel},
    {"microscope", "Floats",
     "An edge's samples in float beside the exact fractions: what the additions lose.",
     draw_microscope_panel},
    {"history", "History", "Everything that falls on the picked pixel, in the order of drawing.",
     draw_history_panel},
    {"graph", "Graph", "A value along a row: the truth, and the straight line between its ends.",
     draw_graph_panel},
    {"compare", "Compare", "Two runs with other settings: what differs, where first, and why.",
     draw_compare_panel},
    {"lab", "Lab", "The mistakes that rasterizers make: turn one on, and see what it does.",
     draw_lab_panel},
    {"settings", "Settings", "Every choice that changes the picture.", draw_settings_panel},
};

void draw_tab(Ui& ui, const Tab& tab, ImVec2 at, float width, float height, bool chosen) {
    const Palette& p = palette(ui.options.theme);
    const std::string name = std::string("tab.") + tab.name;
    ImGui::SetCursorScreenPos(at);
    if (ImGui::InvisibleButton(name.c_str(), {width, height})) open_tab(ui, tab.name);
    const bool hovered = ImGui::IsItemHovered();
    name_widget(ui, name, tab.help);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float text = ImGui::CalcTextSize(tab.title).x;
    list->AddText({at.x + 0.5f * (width - text), at.y + 0.5f * (height - ImGui::GetFontSize())},
                  packed(chosen || hovered ? p.text : p.dim), tab.title);
    if (chosen) {
        list->AddRectFilled({at.x, at.y + height - 2.0f * ui.options.text_scale},
                            {at.x + width, at.y + height}, packed(p.link));
    }
}

/// A page below this size is one of little room, design pixels.
constexpr float low_page = 330.0f;
constexpr float narrow_page = 345.0f;

using Tabs = std::vector<const Tab*>;

/// Around a tab's title, design pixels: as it should be, and where room is short.
constexpr float roomy_padding = 15.0f;
constexpr float tight_padding = 8.0f;

std::vector<float> tab_widths(const Ui& ui, const Tabs& shown, float padding) {
    std::vector<float> widths;
    for (const Tab* tab : shown) {
        widths.push_back(ImGui::CalcTextSize(tab->title).x + padding * ui.options.text_scale);
    }
    return widths;
}

/// The tabs side by side, in as many lines as they need. Returns where the page begins.
float draw_tab_lines(Ui& ui, const Tabs& shown, const Tab* chosen, float padding) {
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const std::vector<float> widths = tab_widths(ui, shown, padding);
    const std::vector<FlowPlace> places = flow(widths, 0.0f, ImGui::GetContentRegionAvail().x);
    const float height = 32.0f * u;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const ImVec2 at{start.x + places[i].x,
                        start.y + static_cast<float>(places[i].line) * height};
        draw_tab(ui, *shown[i], at, widths[i], height, shown[i] == chosen);
    }
    return start.y + static_cast<float>(line_count(places)) * height;
}

/// One list instead of tabs, where every line of the window counts.
float draw_tab_list(Ui& ui, const Tabs& shown, const Tab* chosen) {
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##tabs", chosen->title, ImGuiComboFlags_HeightLargest);
    name_widget(ui, "tabs", "What the inspector shows.");
    const float bottom = ImGui::GetItemRectMax().y + ImGui::GetStyle().ItemSpacing.y;
    if (open) {
        for (const Tab* tab : shown) {
            if (ImGui::Selectable(tab->title, tab == chosen)) open_tab(ui, tab->name);
            name_widget(ui, std::string("tab.") + tab->name, tab->help);
        }
        ImGui::EndCombo();
    }
    return bottom;
}

/// The tabs in the largest form that fits. Returns where the page begins.
float draw_tabs(Ui& ui, const Tabs& shown, const Tab* chosen) {
    const float room = ImGui::GetContentRegionAvail().x;
    const auto fits = [&](float padding) {
        return line_count(flow(tab_widths(ui, shown, padding), 0.0f, room)) == 1;
    };
    if (fits(roomy_padding)) return draw_tab_lines(ui, shown, chosen, roomy_padding);
    ImGui::PushFont(ui.fonts.small);
    const float padding = fits(roomy_padding) ? roomy_padding : tight_padding;
    const bool as_list = !fits(padding) && is_compact(ImGui::GetIO().DisplaySize, ui.options);
    const float bottom = as_list ? 0.0f : draw_tab_lines(ui, shown, chosen, padding);
    ImGui::PopFont();
    return as_list ? draw_tab_list(ui, shown, chosen) : bottom;
}

} // namespace

void draw_inspector(Ui& ui, const Layout& layout) {
    const Area& area = layout.inspector;
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::Begin("inspector", nullptr, panel_flags);
    Tabs shown;
    if (layout.lesson_is_tab) shown.push_back(&lesson_tab);
    for (const Tab& tab : tabs)
        shown.push_back(&tab);
    const Tab* chosen = nullptr;
    for (const Tab* tab : shown) {
        if (ui.session.tab == tab->name) chosen = tab;
    }
    if (layout.lesson_is_tab && ui.lesson.covers_inspector) chosen = &lesson_tab;
    if (chosen == nullptr) chosen = shown.front();

    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float bottom = draw_tabs(ui, shown, chosen);
    ImGui::GetWindowDrawList()->AddLine({start.x, bottom}, {start.x + room, bottom},
                                        packed(palette(ui.options.theme).line));
    ImGui::SetCursorScreenPos({start.x, bottom + 9.0f * u});
    const ImVec2 page = ImGui::GetContentRegionAvail();
    ui.inspector.is_low = page.y < low_page * u;
    ui.inspector.is_narrow = page.x < narrow_page * u;
    // The page scrolls, the tabs stay.
    ImGui::BeginChild(chosen->name, {0, 0}, false, ImGuiWindowFlags_NoNav);
    chosen->draw(ui);
    ImGui::EndChild();
    ImGui::End();
}

} // namespace rasterwalk
