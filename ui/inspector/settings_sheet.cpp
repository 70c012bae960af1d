#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/letter_case.h"
#include "settings/idle_setting.h"
#include "settings/setting_table.h"
#include "settings/value_words.h"
#include "ui/actions/open_tab.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/setting_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

bool is_wanted(const Setting& setting, const std::string& search) {
    const std::string_view texts[] = {setting.name, setting.title, setting.help, setting.group};
    return std::any_of(std::begin(texts), std::end(texts),
                       [&](std::string_view text) { return contains_in_any_case(text, search); });
}

/// Screen pixels that the field of a setting needs, whatever is chosen in it.
float field_width(const Ui& ui, const Setting& setting) {
    const float u = ui.options.text_scale;
    if (std::holds_alternative<VectorSetting>(setting.kind)) return 200.0f * u;
    if (std::holds_alternative<SizeSetting>(setting.kind)) return 130.0f * u;
    if (std::holds_alternative<BoxSetting>(setting.kind)) return 280.0f * u;
    const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
    if (choice == nullptr) return 75.0f * u;
    float widest = 0.0f;
    for (const std::string_view word : choice->words)
        widest = std::max(widest, button_width(choice_words(setting, word)));
    return widest + ImGui::GetFrameHeight(); // with the arrow of the list
}

/// How a line of the sheet is divided, screen pixels.
struct SheetColumns {
    float name;  ///< where the field begins
    float reset; ///< where the reset button begins
    float width; ///< of the whole line
};

SheetColumns sheet_columns(const Ui& ui) {
    const float u = ui.options.text_scale;
    const float width = ImGui::GetContentRegionAvail().x;
    const float reset = width - 30.0f * u;
    return {std::min(0.46f * width, 215.0f * u), reset, width};
}

/// What is said about settings that do nothing.
std::string idle_text(const std::string& reason) {
    return "no effect " + reason;
}

std::string tooltip_of_setting(const Setting& setting, const std::string& idle) {
    std::string about = std::string(setting.name).append("\n").append(setting.help);
    if (!idle.empty()) about.append("\nIt has ").append(idle_text(idle)).append(".");
    about.append("\nLab: ").append(setting.section);
    if (!setting.unit.empty()) about.append("\nUnit: ").append(setting.unit);
    return about;
}

/// Name, field, and reset button, on one line; on two if the field needs it.
/// @param idle why it does nothing; empty: it acts
void draw_setting(Ui& ui, const Setting& setting, const Settings& usual,
                  const SheetColumns& columns, const std::string& idle) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string name(setting.name);
    const std::string usual_text = value_text(setting, usual);
    const bool differs = value_text(setting, ui.session.a.settings) != usual_text;
    const float begin = ImGui::GetCursorPosX();
    const float top = ImGui::GetCursorScreenPos().y;
    const float indent = setting.ties.part_of.empty() ? 0.0f : 14.0f * u;
    const std::string title(setting.title);
    const bool fits = columns.reset - columns.name >= field_width(ui, setting) &&
                      columns.name - indent - 8.0f * u >= ImGui::CalcTextSize(title.c_str()).x;
    const float room = (fits ? columns.name : columns.reset) - indent - 8.0f * u;
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosX(begin + indent);
    text_in(!idle.empty() ? p.dim : differs ? p.changed : p.text, shortened(title, room));
    register_widget(ui, "setting_name." + name, tooltip_of_setting(setting, idle));
    if (fits) ImGui::SameLine();
    ImGui::SetCursorPosX(begin + (fits ? columns.name : indent));
    ImGui::SetNextItemWidth(columns.reset - (fits ? columns.name : indent) - 4.0f * u);
    // It can still be set, for when it will act.
    if (!idle.empty()) ImGui::PushStyleColor(ImGuiCol_Text, p.dim);
    edit_setting(ui, ui.session.a.settings, setting, "setting." + name);
    if (!idle.empty()) ImGui::PopStyleColor();
    clip_range_to_lines(top, ImGui::GetItemRectMax().y);
    if (differs) {
        ImGui::SameLine();
        ImGui::SetCursorPosX(begin + columns.reset);
        if (button(ui, "reset." + name, "↺", Look::link,
                   "Differs from the handout. Click to set it back to " +
                       value_words(setting, usual) + ".")) {
            set_value(ui.session.a.settings, setting, usual_text);
        }
    }
    ImGui::PopID();
}

/// Which settings come first is decided when the sheet opens, and at every step of a lesson: none
/// moves away from the pointer, whether it is changed or reset.
void record_changed(Ui& ui, const Settings& usual) {
    SettingsSheet& sheet = ui.inspector.settings_sheet;
    const int frame = ImGui::GetFrameCount();
    const bool was_open = sheet.frame + 1 >= frame && sheet.lesson == ui.session.lesson &&
                          sheet.step == ui.session.step;
    sheet.frame = frame;
    if (was_open) return;
    sheet.lesson = ui.session.lesson;
    sheet.step = ui.session.step;
    sheet.changed.clear();
    for (const Setting& setting : setting_table()) {
        if (has_same_value(setting, usual, ui.session.a.settings)) continue;
        sheet.changed.push_back(setting.name);
    }
}

bool is_first(const Ui& ui, const Setting& setting) {
    const std::vector<std::string_view>& first = ui.inspector.settings_sheet.changed;
    return std::find(first.begin(), first.end(), setting.name) != first.end();
}

/// The heading over the settings that come first.
std::string_view heading_of_changed(const Ui& ui, const Settings& usual) {
    const std::vector<std::string_view>& first = ui.inspector.settings_sheet.changed;
    const bool is_any_set_back = std::any_of(first.begin(), first.end(), [&](auto name) {
        return has_same_value(*find_setting(name), usual, ui.session.a.settings);
    });
    return is_any_set_back ? "Changed or set back" : "Changed";
}

void draw_heading(Ui& ui, std::string_view text) {
    ImGui::Spacing();
    text_in(palette(ui.options.theme).dim, text, ui.fonts.bold);
}

/// Said before settings that do nothing.
void draw_idle_reason(Ui& ui, const Setting& first, const std::string& reason) {
    wrapped_text_in(palette(ui.options.theme).dim, idle_text(reason) + ":", ui.fonts.small);
    register_widget(
        ui, "setting_idle." + std::string(first.name),
        "The grey settings below can be changed, but have no effect on the picture for now.");
}

/// The beginning of a preset's description: all that has room next to its button.
std::string_view brief(std::string_view about) {
    return about.substr(0, about.find_first_of(":."));
}

bool preset_button(Ui& ui, const Preset& preset, float width) {
    const bool is_pressed = button(ui, "settings.preset." + preset.name, preset.name, Look::plain,
                                   preset.about, {width, 0.0f});
    return is_pressed;
}

/// Where lines are few: what each does is left to its tooltip.
void draw_presets_in_a_row(Ui& ui) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    for (const Preset& preset : ui.session.presets) {
        const bool is_first = &preset == &ui.session.presets.front();
        const float end = ImGui::GetItemRectMax().x + gap + button_width(preset.name);
        if (!is_first && end <= right) ImGui::SameLine(0.0f, gap);
        if (preset_button(ui, preset, 0.0f)) apply_preset(preset, ui.session.a.settings);
    }
}

/// Each next to what it does.
void draw_presets(Ui& ui) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    float widest = 0.0f;
    for (const Preset& preset : ui.session.presets)
        widest = std::max(widest, button_width(preset.name));
    if (!ui.session.presets.empty()) draw_heading(ui, "Presets");
    for (const Preset& preset : ui.session.presets) {
        const ImVec2 start = ImGui::GetCursorScreenPos();
        if (preset_button(ui, preset, widest)) apply_preset(preset, ui.session.a.settings);
        const float bottom = ImGui::GetItemRectMax().y;
        ImGui::PushFont(ui.fonts.small);
        ImGui::SetCursorScreenPos({start.x + widest + gap, start.y});
        const std::string words =
            broken_into_lines(brief(preset.about), ImGui::GetContentRegionAvail().x);
        const float height = ImGui::CalcTextSize(words.c_str()).y;
        const float button_height = bottom - start.y;
        ImGui::SetCursorScreenPos(
            {start.x + widest + gap, start.y + std::max(0.5f * (button_height - height), 0.0f)});
        text_in(palette(ui.options.theme).dim, words);
        ImGui::PopFont();
        ImGui::SetCursorScreenPos(
            {start.x, start.y + std::max(button_height, height) + ImGui::GetStyle().ItemSpacing.y});
    }
}

void draw_all_settings(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const bool is_searched = !ui.inspector.setting_search.empty();
    if (!is_searched && ui.inspector.is_low) draw_presets_in_a_row(ui);
    if (!is_searched && !ui.inspector.is_low) draw_presets(ui);
    const Settings usual = default_settings(*ui.session.scene);
    record_changed(ui, usual);
    const SheetColumns columns = sheet_columns(ui);
    std::string_view heading;
    bool any = false;
    std::string idle_before;
    const auto draw = [&](const Setting& setting, std::string_view under) {
        any = true;
        if (under != heading) {
            draw_heading(ui, heading = under);
            idle_before.clear();
        }
        // For several in a row the reason is given once, before the first.
        const std::string idle = idle_reason(setting, ui.session.a.settings);
        if (!idle.empty() && idle != idle_before) draw_idle_reason(ui, setting, idle);
        idle_before = idle;
        draw_setting(ui, setting, usual, columns, idle);
    };
    for (const bool changed : {true, false}) {
        for (const Setting& setting : setting_table()) {
            if (is_first(ui, setting) != changed) continue;
            if (!is_wanted(setting, ui.inspector.setting_search)) continue;
            if (!changed && !is_searched &&
                !is_of_use(setting, *ui.session.scene, ui.session.a.settings))
                continue;
            draw(setting, changed ? heading_of_changed(ui, usual) : setting.group);
        }
    }
    if (!any) text_in(p.dim, "No setting contains that word.");
}

/// Title, search, and the button that closes it.
void draw_sheet_head(Ui& ui) {
    const float u = ui.options.text_scale;
    ImGui::AlignTextToFramePadding();
    put_text("Settings", ui.fonts.bold);
    ImGui::SameLine();
    const float side = button_width("Close");
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 8.0f * u);
    if (!hides_settings(ui.session)) {
        ImGui::SetNextItemWidth(std::max(right - side - 8.0f * u - ImGui::GetCursorPosX(), 1.0f));
        ImGui::InputTextWithHint("##search", "search", &ui.inspector.setting_search);
        register_widget(ui, "settings.search",
                        "Shows only the settings whose name or help contains this word.");
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(right - side);
    if (button(ui, "settings.close", "Close", Look::plain, "Back to the tab below.\nKey: Escape",
               {side, 0})) {
        close_settings_sheet(ui);
    }
}

} // namespace

void draw_settings_sheet(Ui& ui) {
    draw_sheet_head(ui);
    if (hides_settings(ui.session)) {
        wrapped_text("The settings are hidden until the quiz in the Mistakes tab is over.");
        register_widget(ui, "settings.hidden", "They would give the mistake away.");
        return;
    }
    // The list scrolls, its head stays.
    ImGui::BeginChild("settings.list", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_line_clip();
    draw_all_settings(ui);
    end_line_clip();
    ImGui::EndChild();
}

} // namespace rasterwalk
