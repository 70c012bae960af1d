#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "ui/actions/open_tab.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

bool contains_word(std::string_view text, std::string_view word) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

bool is_wanted(const Setting& setting, const std::string& search) {
    return search.empty() || contains_word(setting.name, search) ||
           contains_word(setting.title, search) || contains_word(setting.help, search) ||
           contains_word(setting.group, search);
}

/// Design pixels that the field of a setting needs.
float field_width(const Setting& setting) {
    if (std::holds_alternative<VectorSetting>(setting.kind)) return 200.0f;
    if (std::holds_alternative<SizeSetting>(setting.kind)) return 130.0f;
    if (std::holds_alternative<NumberSetting>(setting.kind)) return 75.0f;
    return 110.0f;
}

/// What a line of the sheet is divided into, screen pixels.
struct SheetColumns {
    float name;  ///< where the field begins
    float reset; ///< where the button begins that sets it back
    float width; ///< of the whole line
};

SheetColumns sheet_columns(const Ui& ui) {
    const float u = ui.options.text_scale;
    const float width = ImGui::GetContentRegionAvail().x;
    const float reset = width - 30.0f * u;
    return {std::min(0.46f * width, 215.0f * u), reset, width};
}

std::string tooltip_of_setting(const Setting& setting) {
    std::string about = std::string(setting.name).append("\n").append(setting.help);
    about.append("\nLab: ").append(setting.section);
    if (!setting.unit.empty()) about.append("\nUnit: ").append(setting.unit);
    return about;
}

/// Name, field, and a button that sets it back, on one line; on two where the field needs it.
void draw_setting(Ui& ui, const Setting& setting, const Settings& usual,
                  const SheetColumns& columns) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string name(setting.name);
    const std::string usual_text = value_text(setting, usual);
    const bool differs = value_text(setting, ui.session.a.settings) != usual_text;
    const float begin = ImGui::GetCursorPosX();
    const bool fits = columns.reset - columns.name >= field_width(setting) * u;
    const float indent = setting.part_of.empty() ? 0.0f : 14.0f * u;
    const float room = (fits ? columns.name : columns.reset) - indent - 8.0f * u;
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosX(begin + indent);
    text_in(differs ? p.changed : p.text, shortened(std::string(setting.title), room));
    name_widget(ui, "setting_name." + name, tooltip_of_setting(setting));
    if (fits) ImGui::SameLine();
    ImGui::SetCursorPosX(begin + (fits ? columns.name : indent));
    ImGui::SetNextItemWidth(columns.reset - (fits ? columns.name : indent) - 4.0f * u);
    edit_setting(ui, ui.session.a.settings, setting, "setting." + name);
    if (differs) {
        ImGui::SameLine();
        ImGui::SetCursorPosX(begin + columns.reset);
        if (button(ui, "reset." + name, "↺", Look::link,
                   "Differs from the handout; sets it back to " + said_value(setting, usual) +
                       ".")) {
            set_value(ui.session.a.settings, setting, usual_text);
        }
    }
    ImGui::PopID();
}

/// Which settings come first is asked when the sheet opens, so that none leaves its place under the
/// student's hand. One that is set back is changed no more, and goes.
void note_changed(Ui& ui, const Settings& usual) {
    InspectorState& state = ui.inspector;
    const Settings& now = ui.session.a.settings;
    const int frame = ImGui::GetFrameCount();
    const bool was_open = state.settings_frame + 1 >= frame;
    state.settings_frame = frame;
    if (was_open) {
        if (ImGui::IsAnyItemActive()) return; // a number that is dragged may pass its default
        std::erase_if(state.changed_settings, [&](std::string_view name) {
            return has_same_value(*find_setting(name), usual, now);
        });
        return;
    }
    state.changed_settings.clear();
    for (const Setting& setting : setting_table()) {
        if (has_same_value(setting, usual, now)) continue;
        state.changed_settings.push_back(setting.name);
    }
}

bool is_first(const Ui& ui, const Setting& setting) {
    const std::vector<std::string_view>& first = ui.inspector.changed_settings;
    return std::find(first.begin(), first.end(), setting.name) != first.end();
}

void draw_heading(Ui& ui, std::string_view text) {
    ImGui::Spacing();
    ImGui::PushFont(ui.fonts.bold);
    text_in(palette(ui.options.theme).dim, text);
    ImGui::PopFont();
}

void draw_presets(Ui& ui) {
    std::vector<float> widths;
    for (const Preset& preset : ui.session.presets)
        widths.push_back(button_width(preset.name));
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const std::vector<FlowPlace> places = flow(widths, gap, ImGui::GetContentRegionAvail().x);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Preset& preset = ui.session.presets[i];
        ImGui::SetCursorScreenPos(
            {start.x + places[i].x, start.y + static_cast<float>(places[i].line) * line});
        if (button(ui, "settings.preset." + preset.name, preset.name, Look::plain, preset.about)) {
            apply_preset(preset, ui.session.a.settings);
        }
    }
}

void draw_all_settings(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    draw_presets(ui);
    const Settings usual = default_settings(*ui.session.scene);
    note_changed(ui, usual);
    const SheetColumns columns = sheet_columns(ui);
    std::string_view heading;
    bool any = false;
    const auto draw = [&](const Setting& setting, std::string_view under) {
        any = true;
        if (under != heading) draw_heading(ui, heading = under);
        draw_setting(ui, setting, usual, columns);
    };
    for (const bool changed : {true, false}) {
        for (const Setting& setting : setting_table()) {
            if (is_first(ui, setting) != changed) continue;
            if (!is_wanted(setting, ui.inspector.setting_search)) continue;
            draw(setting, changed ? std::string_view("Changed") : setting.group);
        }
    }
    if (!any) text_in(p.dim, "No setting has that word.");
}

/// Title, search, and a cross.
void draw_sheet_head(Ui& ui) {
    const float u = ui.options.text_scale;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted("Settings");
    ImGui::PopFont();
    ImGui::SameLine();
    const float side = ImGui::GetFrameHeight();
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 8.0f * u);
    if (!hides_settings(ui.session)) {
        ImGui::SetNextItemWidth(std::max(right - side - 8.0f * u - ImGui::GetCursorPosX(), 1.0f));
        ImGui::InputTextWithHint("##search", "search", &ui.inspector.setting_search);
        name_widget(ui, "settings.search",
                    "Shows only the settings whose name or help has this word.");
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(right - side);
    if (button(ui, "settings.close", "✗", Look::quiet, "Back to the tab below.\nKey: Escape",
               {side, 0})) {
        close_settings_sheet(ui);
    }
}

} // namespace

void draw_settings_sheet(Ui& ui) {
    draw_sheet_head(ui);
    if (hides_settings(ui.session)) {
        wrapped_text("The settings are hidden until the quiz is over: the Mistakes tab has it.");
        name_widget(ui, "settings.hidden", "They would give the mistake away.");
        return;
    }
    // The list scrolls, its head stays.
    ImGui::BeginChild("settings.list", {0, 0}, false, ImGuiWindowFlags_NoNav);
    draw_all_settings(ui);
    ImGui::EndChild();
}

} // namespace rasterwalk
