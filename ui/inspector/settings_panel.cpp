#include <algorithm>
#include <cctype>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/error.h"
#include "settings/setting_table.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
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
           contains_word(setting.help, search) || contains_word(setting.group, search);
}

void edit_choice(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                 const ChoiceSetting& choice) {
    const int now = choice.read(settings);
    const std::string shown(now == no_word ? std::string_view("mixed") : choice.words[now]);
    const bool open = ImGui::BeginCombo("##value", shown.c_str());
    name_widget(ui, name, help);
    if (!open) return;
    for (int i = 0; i < static_cast<int>(choice.words.size()); ++i) {
        if (ImGui::Selectable(std::string(choice.words[i]).c_str(), i == now)) {
            choice.write(settings, i);
        }
        name_widget(ui, name + "=" + std::string(choice.words[i]), help);
    }
    ImGui::EndCombo();
}

/// Numbers are dragged, or typed after a double click; they never leave their range.
void edit_number(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                 const NumberSetting& number) {
    float value = number.value(settings);
    if (ImGui::DragFloat("##value", &value, number.drag_step, number.smallest, number.largest,
                         "%.3f", ImGuiSliderFlags_AlwaysClamp)) {
        number.value(settings) = value;
    }
    name_widget(ui, name, help);
}

void edit_vector(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                 const VectorSetting& vector) {
    glm::vec3 value = vector.value(settings);
    if (ImGui::DragFloat3("##value", &value.x, vector.drag_step, vector.smallest, vector.largest,
                          "%.3f", ImGuiSliderFlags_AlwaysClamp)) {
        vector.value(settings) = value;
    }
    name_widget(ui, name, help);
}

void edit_size(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
               const SizeSetting& size) {
    Viewport& viewport = size.value(settings);
    int sides[2] = {viewport.width, viewport.height};
    if (ImGui::InputInt2("##value", sides, ImGuiInputTextFlags_EnterReturnsTrue)) {
        viewport = {std::clamp(sides[0], 1, size.largest), std::clamp(sides[1], 1, size.largest)};
    }
    name_widget(ui, name, help);
}

void draw_setting(Ui& ui, const Setting& setting, const Settings& usual) {
    const Palette& p = palette(ui.options.theme);
    const std::string name(setting.name);
    const std::string usual_text = value_text(setting, usual);
    const bool differs = value_text(setting, ui.session.a.settings) != usual_text;
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    text_in(differs ? p.changed : p.text, name);
    std::string about = std::string(setting.help) + "\nLab: " + std::string(setting.section);
    if (!setting.unit.empty()) about += "\nUnit: " + std::string(setting.unit);
    name_widget(ui, "setting_name." + name, about);
    if (differs) {
        ImGui::SameLine();
        if (button(ui, "reset." + name, "reset", Look::link,
                   "Differs from the handout; sets it back to " + usual_text + ".")) {
            set_value(ui.session.a.settings, setting, usual_text);
        }
    }
    ImGui::SetNextItemWidth(-1.0f);
    edit_setting(ui, ui.session.a.settings, setting, "setting." + name);
    ImGui::PopID();
}

} // namespace

void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name) {
    const std::string help(setting.help);
    if (const auto* choice = std::get_if<ChoiceSetting>(&setting.kind)) {
        edit_choice(ui, settings, name, help, *choice);
    } else if (const auto* number = std::get_if<NumberSetting>(&setting.kind)) {
        edit_number(ui, settings, name, help, *number);
    } else if (const auto* vector = std::get_if<VectorSetting>(&setting.kind)) {
        edit_vector(ui, settings, name, help, *vector);
    } else if (const auto* size = std::get_if<SizeSetting>(&setting.kind)) {
        edit_size(ui, settings, name, help, *size);
    }
}

void draw_settings_panel(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    if (hides_settings(ui.session)) {
        wrapped_text("The settings are hidden until the quiz is over: the Lab tab has it.");
        name_widget(ui, "settings.hidden", "They would give the mistake away.");
        return;
    }
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##search", "search the settings", &ui.inspector.setting_search);
    name_widget(ui, "settings.search", "Shows only the settings whose name or help has this word.");
    for (const Preset& preset : ui.session.presets) {
        if (button(ui, "settings.preset." + preset.name, preset.name, Look::plain, preset.about)) {
            apply_preset(preset, ui.session.a.settings);
        }
        ImGui::SameLine();
    }
    ImGui::NewLine();
    const Settings usual = default_settings(*ui.session.scene);
    std::string_view group;
    bool any = false;
    for (const Setting& setting : setting_table()) {
        if (!is_wanted(setting, ui.inspector.setting_search)) continue;
        any = true;
        if (setting.group != group) {
            group = setting.group;
            ImGui::Spacing();
            ImGui::PushFont(ui.fonts.bold);
            text_in(p.dim, group);
            ImGui::PopFont();
        }
        draw_setting(ui, setting, usual);
    }
    if (!any) text_in(p.dim, "No setting has that word.");
}

} // namespace rasterwalk
