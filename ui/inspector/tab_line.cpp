#include <algorithm>
#include <string>
#include <vector>

#include "ui/actions/open_tab.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

using Tabs = std::vector<const TabInfo*>;

/// A word that can be clicked, without a frame.
bool draw_word(Ui& ui, const std::string& name, std::string_view word, std::string_view help,
               ImVec2 at, float height, const ImVec4& colour, const ImVec4& colour_hovered) {
    const ImVec2 text = ImGui::CalcTextSize(word.data(), word.data() + word.size());
    ImGui::SetCursorScreenPos(at);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), {std::max(text.x, 1.0f), height});
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, name, help);
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + 0.5f * (height - text.y)},
                                        packed(hovered ? colour_hovered : colour), word.data(),
                                        word.data() + word.size());
    return pressed;
}

/// Who chose the tab shown: words for the right end of the line.
struct Chooser {
    std::string said;   ///< first, quiet
    std::string action; ///< a link after it; empty: none
    std::string widget;
    std::string help;
    void (*run)(Ui&) = nullptr;
};

Chooser chooser_of(const Session& session) {
    const std::string guide = session.lesson.empty() ? "stage" : "lesson";
    if (hides_tabs(session)) {
        return {"", "show all", "tabs.show_all",
                "The lesson shows only what this step needs. Click to show all groups and tabs.",
                [](Ui& ui) { ui.session.tab_guide.shows_all = true; }};
    }
    if (!session.tab_guide.before_compare.empty()) {
        return {"while you compare", "", "tabs.follows",
                "The comparison opened its own tab. The previous tab comes back when it ends.",
                nullptr};
    }
    if (!session.tab_guide.is_own) {
        return {"follows the " + guide, "", "tabs.follows",
                "The " + guide + " chooses the tab, until you click one.", nullptr};
    }
    return {"yours ·", "follow " + guide, "tabs.follow",
            "You chose the tab. Click to let the " + guide + " choose it again.",
            [](Ui& ui) { follow_guide(ui.session); }};
}

/// At the right end of the line, if it fits to the right of `left`.
void draw_chooser(Ui& ui, const Chooser& chooser, float left, float right, float y, float height) {
    const Palette& p = palette(ui.options.theme);
    const float gap =
        chooser.said.empty() || chooser.action.empty() ? 0.0f : 5.0f * ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    float said = text_width(chooser.said);
    const float action = text_width(chooser.action);
    // Plain words are left out before what can be clicked.
    const bool has_room = right - said - gap - action >= left;
    if (!has_room) said = 0.0f;
    float x = right - said - (has_room ? gap : 0.0f) - action;
    if (x >= left && has_room && said > 0.0f) {
        if (chooser.action.empty()) {
            draw_word(ui, chooser.widget, chooser.said, chooser.help, {x, y}, height, p.dim, p.dim);
        } else {
            ImGui::GetWindowDrawList()->AddText({x, y + 0.5f * (height - ImGui::GetFontSize())},
                                                packed(p.dim), chooser.said.c_str());
        }
        x += said + gap;
    }
    if (x >= left && !chooser.action.empty() &&
        draw_word(ui, chooser.widget, chooser.action, chooser.help, {x, y}, height, p.link,
                  p.text)) {
        chooser.run(ui);
    }
    ImGui::PopFont();
}

} // namespace

Tabs offered_tabs(const Ui& ui, std::optional<TabGroup> group) {
    Tabs tabs;
    for (const TabInfo& tab : tab_list()) {
        if ((!group || tab.group == *group) && offers_tab(ui, tab)) tabs.push_back(&tab);
    }
    return tabs;
}

float draw_tab_line(Ui& ui, const InspectorLook& look) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float height = 30.0f * u;
    const Tabs tabs = offered_tabs(ui, look.group);
    float gap = 18.0f * u;
    float x = start.x;
    for (const TabInfo* tab : tabs) {
        const bool chosen = tab->name == tab_below(ui.session);
        const std::string name = std::string("tab.").append(tab->name);
        const TabWords words = tab_words(*tab, ui.session.a.settings);
        const float width = text_width(words.title);
        if (draw_word(ui, name, words.title, words.help, {x, start.y}, height,
                      chosen ? p.text : p.dim, p.text)) {
            open_tab(ui, tab->name);
        }
        register_text(ui, name, words.title);
        if (chosen) {
            ImGui::GetWindowDrawList()->AddRectFilled(
                {x, start.y + height - 2.0f * u}, {x + width, start.y + height}, packed(p.link));
        }
        x += width + gap;
    }
    draw_chooser(ui, chooser_of(ui.session), x, start.x + room, start.y, height);
    const float bottom = start.y + height;
    ImGui::GetWindowDrawList()->AddLine({start.x, bottom}, {start.x + room, bottom},
                                        packed(p.line));
    return bottom;
}

float draw_tab_list(Ui& ui) {
    const std::string_view below = tab_below(ui.session);
    const Tabs tabs = offered_tabs(ui, std::nullopt);
    const auto shown = std::find_if(tabs.begin(), tabs.end(),
                                    [&](const TabInfo* tab) { return tab->name == below; });
    const auto words_of = [&](const TabInfo& tab) { return tab_words(tab, ui.session.a.settings); };
    const std::string title(shown != tabs.end() ? words_of(**shown).title : std::string_view());
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##tabs", title.c_str(), ImGuiComboFlags_HeightLargest);
    register_widget(ui, "tabs", "What the inspector shows.", title);
    const float bottom = ImGui::GetItemRectMax().y + ImGui::GetStyle().ItemSpacing.y;
    if (!open) return bottom;
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        if (i > 0 && tabs[i]->group != tabs[i - 1]->group) ImGui::Separator();
        const bool chosen = tabs[i]->name == below;
        const TabWords words = words_of(*tabs[i]);
        if (list_entry(ui, std::string("tab.").append(tabs[i]->name), words.title, chosen,
                       words.help)) {
            open_tab(ui, tabs[i]->name);
        }
    }
    if (hides_tabs(ui.session)) {
        ImGui::Separator();
        if (ImGui::Selectable("show all")) ui.session.tab_guide.shows_all = true;
        register_widget(ui, "tabs.show_all",
                        "All groups and tabs, not only those that this step needs.");
    }
    ImGui::EndCombo();
    return bottom;
}

} // namespace rasterwalk
