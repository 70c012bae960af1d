#include <algorithm>
#include <string>

#include <imgui.h>

#include "settings/setting_table.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

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

} // namespace rasterwalk
