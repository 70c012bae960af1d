#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/actions/open_tab.h"
#include "ui/inspector/code_parts.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The contents of a button of the row.
struct GroupButton {
    std::string name; ///< of the widget
    std::string title;
    std::string subject;      ///< what its tabs are about now
    bool has_subject = false; ///< false: the subject says that there is none
    std::string tab;          ///< the tab that a click opens
    std::string help;
    bool chosen = false;
};

constexpr std::array group_help{
    "The triangle shown: its vertices, its rows, and what floats do to its edges.",
    "The picked pixel: the fragment on it, everything that fell on it, and values along its row.",
    "The run shown, a second one next to it, the mistakes that rasterizers make, and what makes "
    "them fast.",
    "The lab's functions in C++, line by line, with the values of this moment.",
};
constexpr std::array group_titles{"Triangle", "Pixel", "Runs", "Code"};
static_assert(group_help.size() == tab_group_count && group_titles.size() == tab_group_count);

std::string subject_of_runs(const Session& session) {
    if (session.quiz) return "quiz";
    if (!session.b) return "one run";
    const bool is_mistake = session.replaced && !session.replaced->bug.empty();
    return is_mistake ? session.replaced->bug : "A | B";
}

void fill_subject(const Ui& ui, TabGroup group, GroupButton& button) {
    const auto& pixel = ui.session.selection.pixel;
    const auto& triangle = ui.results.a.triangle;
    button.has_subject = true;
    if (group == TabGroup::runs) {
        button.subject = subject_of_runs(ui.session);
    } else if (group == TabGroup::code) {
        button.subject = code_subject(ui);
    } else if (group == TabGroup::triangle && triangle) {
        button.subject = "triangles[" + std::to_string(*triangle) + "]";
    } else if (group == TabGroup::pixel && pixel) {
        button.subject = "(" + std::to_string(pixel->x) + ", " + std::to_string(pixel->y) + ")";
    } else {
        button.subject = "none picked";
        button.has_subject = false;
    }
}

std::vector<GroupButton> buttons_of(const Ui& ui, const InspectorLook& look) {
    std::vector<GroupButton> buttons;
    for (std::size_t i = 0; i < tab_group_count; ++i) {
        const auto group = static_cast<TabGroup>(i);
        const std::string_view tab = tab_of_group(ui.session, group);
        if (tab.empty()) continue; // the lesson hides all of its tabs
        GroupButton button;
        button.name = std::string("group.").append(word_of(group));
        button.title = group_titles[i];
        button.tab = tab;
        button.help = group_help[i];
        button.chosen = look.group == group && !look.is_covered;
        fill_subject(ui, group, button);
        buttons.push_back(button);
    }
    return buttons;
}

/// Padding around a button's words: the same as on the page, where there is room.
float padding(float width) {
    return std::min(ImGui::GetStyle().WindowPadding.x, 0.12f * width);
}

void draw_button(Ui& ui, const GroupButton& button, ImVec2 at, ImVec2 size, bool has_two_lines) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetCursorScreenPos(at);
    if (ImGui::InvisibleButton(button.name.c_str(), size)) open_tab(ui, button.tab);
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, button.name,
                    has_two_lines ? button.help : button.help + "\nNow: " + button.subject,
                    button.subject);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    if (button.chosen) {
        list->AddRectFilled(at, end, packed(p.ground));
        list->AddRectFilled(at, {end.x, at.y + 2.0f * u}, packed(p.link));
    }
    const float room = std::max(size.x - 2.0f * padding(size.x), 1.0f);
    const float x = at.x + padding(size.x);
    const float title_height = ui.fonts.text->FontSize;
    const float subject_height = ui.fonts.mono_small->FontSize;
    const float gap = 2.0f * u;
    const float height = has_two_lines ? title_height + gap + subject_height : title_height;
    const float y = at.y + 0.5f * (size.y - height);
    list->PushClipRect(at, end, true);
    ImFont* const font = button.chosen ? ui.fonts.bold : ui.fonts.text;
    const float wide = text_width(font, button.title);
    ImGui::PushFont(wide <= room ? font : ui.fonts.small);
    list->AddText({x, y}, packed(button.chosen || hovered ? p.text : p.dim),
                  shortened(button.title, room).c_str());
    ImGui::PopFont();
    if (has_two_lines) {
        ImGui::PushFont(ui.fonts.mono_small);
        const ImVec4& colour = button.chosen && button.has_subject ? p.link : p.dim;
        list->AddText({x, y + title_height + gap}, packed(colour),
                      shortened(button.subject, room).c_str());
        ImGui::PopFont();
    }
    list->PopClipRect();
}

} // namespace

float group_row_height(const Ui& ui, bool has_two_lines) {
    return std::round((has_two_lines ? 52.0f : 32.0f) * ui.options.text_scale);
}

void draw_group_buttons(Ui& ui, const InspectorLook& look, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    // The margin of the window belongs to the row.
    ImGui::PushClipRect(area.position, end, false);
    list->AddRectFilled(area.position, end, packed(p.bar));
    const std::vector<GroupButton> buttons = buttons_of(ui, look);
    const float width = area.size.x / static_cast<float>(std::max<std::size_t>(buttons.size(), 1));
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        const float x = std::round(area.position.x + static_cast<float>(i) * width);
        const float next = std::round(area.position.x + static_cast<float>(i + 1) * width);
        draw_button(ui, buttons[i], {x, area.position.y}, {next - x, area.size.y},
                    look.has_two_lines);
        // A thin line between two buttons, neither of which stands out.
        const bool at_chosen =
            buttons[i].chosen || (i + 1 < buttons.size() && buttons[i + 1].chosen);
        if (i + 1 < buttons.size() && !at_chosen) {
            const float inset = 12.0f * u;
            list->AddLine({next, area.position.y + inset}, {next, end.y - inset}, packed(p.line));
        }
    }
    ImGui::PopClipRect();
}

} // namespace rasterwalk
