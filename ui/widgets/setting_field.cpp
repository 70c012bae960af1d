#include "ui/widgets/setting_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "settings/value_words.h"
#include "stages/orthographic.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A word in the list: as it is displayed, and on the right as it is written in files.
bool word_line(const Ui& ui, const std::string& said, const std::string& word, bool is_chosen) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImFont* const mono = ui.fonts.mono_small;
    const float width = text_width(mono, word);
    const float needed = ImGui::CalcTextSize(said.c_str()).x + 18.0f * u + width;
    const ImVec2 size{std::max(needed, ImGui::GetContentRegionAvail().x), 0.0f};
    const bool is_pressed = ImGui::Selectable(("##" + word).c_str(), is_chosen, 0, size);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddText(at, packed(p.text), said.c_str());
    const float below = ImGui::GetFontSize() - mono->FontSize;
    list->AddText(mono, mono->FontSize, {at.x + size.x - width, at.y + 0.7f * below}, packed(p.dim),
                  word.c_str());
    return is_pressed;
}

/// @param offered the words to choose from; empty: all
void edit_choice(Ui& ui, Settings& settings, const Setting& setting, const std::string& name,
                 const ChoiceSetting& choice, const std::vector<int>& offered) {
    const int now = choice.read(settings);
    const float room =
        ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const std::string whole = value_words(setting, settings);
    const std::string said = shortened(whole, std::max(room, 0.0f));
    const std::string code(setting.name);
    const std::string help = (said == whole ? "" : whole + "\n") + std::string(setting.help);
    const bool open = ImGui::BeginCombo("##value", said.c_str());
    register_widget(ui, name,
                    now == no_word ? help
                                   : help + "\nWritten as " + code + " = " +
                                         std::string(choice.words[static_cast<std::size_t>(now)]));
    if (!open) return;
    for (int i = 0; i < static_cast<int>(choice.words.size()); ++i) {
        const bool is_offered =
            offered.empty() || std::find(offered.begin(), offered.end(), i) != offered.end();
        if (!is_offered && i != now) continue;
        const std::string word(choice.words[static_cast<std::size_t>(i)]);
        if (word_line(ui, choice_words(setting, word), word, i == now)) choice.write(settings, i);
        register_widget(ui, name + "=" + word, help);
        ui.widgets[name + "=" + word].is_chosen = i == now;
    }
    ImGui::EndCombo();
}

/// A number is dragged, typed, or moved by the arrows. Returns true if it was changed.
template <typename Bounds>
bool edit_float(Ui& ui, const std::string& name, const std::string& help, const Bounds& bounds,
                float& value) {
    bool is_changed =
        drag_number("##value", value, {bounds.drag_step, bounds.smallest, bounds.largest});
    register_widget(ui, name, help);
    if (const int more = take_arrows(ui, name).more(); more != 0) {
        value = std::clamp(value + static_cast<float>(more) * bounds.drag_step, bounds.smallest,
                           bounds.largest);
        is_changed = true;
    }
    return is_changed;
}

/// Draws a field for each part of a value, side by side under one name: "setting.light.y" is a
/// part of "setting.light".
template <typename Draw>
void draw_parts(Ui& ui, const std::string& name, std::initializer_list<const char*> parts,
                const Draw& draw) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(parts.size());
    const float width = std::floor((ImGui::CalcItemWidth() - (count - 1.0f) * gap) / count);
    ImGui::BeginGroup();
    int index = 0;
    for (const char* const part : parts) {
        if (index > 0) ImGui::SameLine(0.0f, gap);
        ImGui::PushID(index);
        ImGui::SetNextItemWidth(std::max(width, 1.0f));
        draw(name + "." + part, index++);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    register_widget(ui, name);
    WidgetPlace& whole = ui.widgets.at(name);
    whole.id = 0; // its parts have the keyboard, and the help
    whole.has_tooltip = true;
}

void edit_number(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                 const NumberSetting& number) {
    float value = number.value(settings);
    if (edit_float(ui, name, help, number, value)) number.value(settings) = value;
}

/// A slider on which equal distances multiply by equal factors.
void edit_whole(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                const WholeSetting& whole) {
    int value = whole.value(settings);
    bool is_changed = ImGui::SliderInt("##value", &value, whole.smallest, whole.largest, "%d",
                                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    register_widget(ui, name, help);
    if (const int more = take_arrows(ui, name).more(); more != 0) {
        value += more * whole.step;
        is_changed = true;
    }
    if (is_changed) whole.value(settings) = allowed_value(whole, value);
}

void edit_vector(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
                 const VectorSetting& vector) {
    glm::vec3 value = vector.value(settings);
    bool is_changed = false;
    draw_parts(ui, name, {"x", "y", "z"}, [&](const std::string& part, int i) {
        is_changed = edit_float(ui, part, help, vector, value[i]) || is_changed;
    });
    if (is_changed) vector.value(settings) = value;
}

void edit_size(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
               const SizeSetting& size) {
    Viewport& viewport = size.value(settings);
    glm::ivec2 sides(viewport.width, viewport.height);
    bool is_changed = false;
    draw_parts(ui, name, {"width", "height"}, [&](const std::string& part, int i) {
        is_changed =
            ImGui::InputInt("##value", &sides[i], 0, 0, ImGuiInputTextFlags_EnterReturnsTrue) ||
            is_changed;
        register_widget(ui, part, help);
    });
    if (!is_changed) return;
    viewport = {std::clamp(sides.x, 1, size.largest), std::clamp(sides.y, 1, size.largest)};
}

/// The box that shows what the focal length shows, or the nearest one allowed.
ViewBox offered_box(const Settings& settings, const BoxSetting& kind) {
    const ViewBox usual = usual_view_box(vertex_rules(settings, SceneSpace::world));
    const auto half = [&](float side) {
        return std::clamp(side, 0.5f * kind.least_side, kind.largest);
    };
    const float right = half(usual.right), top = half(usual.top);
    return {-right, right, -top, top};
}

/// Without a box the fields hold the one that is offered; the first change in one of them sets it.
void edit_box(Ui& ui, Settings& settings, const std::string& name, const std::string& help,
              const BoxSetting& kind) {
    std::optional<ViewBox>& value = kind.value(settings);
    ViewBox box = value ? *value : offered_box(settings, kind);
    const std::array<float*, 4> sides{&box.left, &box.right, &box.bottom, &box.top};
    bool is_changed = false;
    draw_parts(ui, name, {"left", "right", "bottom", "top"}, [&](const std::string& part, int i) {
        is_changed =
            edit_float(ui, part, help, kind, *sides[static_cast<std::size_t>(i)]) || is_changed;
    });
    if (is_changed && is_allowed(box, kind)) value = box;
}

/// A slider over a range of a number; the arrows go from stop to stop.
void edit_slider(Ui& ui, Settings& settings, const Setting& setting, const std::string& name,
                 const ControlRange& range) {
    float value = slider_value(setting, range, settings);
    bool is_changed = slide_number("##value", value, range);
    register_widget(ui, name, setting.help);
    if (const int more = take_arrows(ui, name).more(); more != 0) {
        value = slider_stop(range, static_cast<double>(value), more);
        is_changed = true;
    }
    if (is_changed) set_slider_value(setting, range, value, settings);
}

} // namespace

void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name,
                  const ControlRange& range) {
    if (const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind)) {
        edit_choice(ui, settings, setting, name, *choice, range.words);
    } else if (is_slider(setting)) {
        edit_slider(ui, settings, setting, name, range);
    }
}

void edit_setting(Ui& ui, Settings& settings, const Setting& setting, const std::string& name) {
    const std::string help(setting.help);
    if (const auto* choice = std::get_if<ChoiceSetting>(&setting.kind)) {
        edit_choice(ui, settings, setting, name, *choice, {});
    } else if (const auto* number = std::get_if<NumberSetting>(&setting.kind)) {
        edit_number(ui, settings, name, help, *number);
    } else if (const auto* whole = std::get_if<WholeSetting>(&setting.kind)) {
        edit_whole(ui, settings, name, help, *whole);
    } else if (const auto* vector = std::get_if<VectorSetting>(&setting.kind)) {
        edit_vector(ui, settings, name, help, *vector);
    } else if (const auto* size = std::get_if<SizeSetting>(&setting.kind)) {
        edit_size(ui, settings, name, help, *size);
    } else if (const auto* box = std::get_if<BoxSetting>(&setting.kind)) {
        edit_box(ui, settings, name, help, *box);
    }
}

} // namespace rasterwalk
