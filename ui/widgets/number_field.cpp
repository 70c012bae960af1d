#include "ui/widgets/number_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <imgui.h>
#include <imgui_internal.h>

#include "base/numbers.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr std::string_view minus_sign = "−";
constexpr ImWchar minus_letter = 0x2212;

/// The host's clipboard, while a field reads it through clipboard_number.
const char* (*host_clipboard)(void*) = nullptr;

const char* clipboard_number(void* host) {
    static std::string text;
    const char* const copied = host_clipboard(host);
    text = copied != nullptr ? copied : "";
    for (std::size_t at = 0; (at = text.find(minus_sign, at)) != text.npos; ++at)
        text.replace(at, minus_sign.size(), "-");
    return text.c_str();
}

/// ImGui drops minus signs other than hyphens: a number typed or pasted with one would lose it.
template <typename Draw>
bool draw_while_typed(const Draw& draw) {
    ImGuiIO& io = ImGui::GetIO();
    for (ImWchar& letter : io.InputQueueCharacters) {
        if (letter == minus_letter) letter = '-';
    }
    host_clipboard = io.GetClipboardTextFn;
    io.GetClipboardTextFn = clipboard_number;
    const bool is_changed = draw();
    io.GetClipboardTextFn = host_clipboard;
    return is_changed;
}

/// ImGui writes hyphens: except during typing, its text is replaced by one with minus signs.
/// @param draw the field
/// @param shown its text, asked for when the field is drawn
/// @param place of the text within the field: 0 left, 1 right
template <typename Draw, typename Shown>
bool draw_field(const char* id, const Draw& draw, const Shown& shown,
                const std::function<float(float width)>& place = {}) {
    const ImGuiID item = ImGui::GetID(id);
    if (ImGui::TempInputIsActive(item)) return draw_while_typed(draw);
    ImGui::PushStyleColor(ImGuiCol_Text, 0);
    const bool is_changed = draw();
    ImGui::PopStyleColor();
    if (ImGui::TempInputIsActive(item)) return is_changed; // from now on
    const std::string text = shown();
    const float across = place ? place(ImGui::CalcTextSize(text.c_str()).x) : 0.5f;
    ImGui::RenderTextClipped(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), text.data(),
                             text.data() + text.size(), nullptr, {across, 0.5f});
    return is_changed;
}

/// How many digits after the point tell the stops of a slider apart.
int digits_of(const ControlRange& range) {
    constexpr int most_digits = 7;
    for (int digits = 0; digits < most_digits; ++digits) {
        const double factor = std::pow(10.0, digits);
        const auto is_whole = [&](double number) {
            const double off = std::abs(number * factor - std::round(number * factor));
            return off < 1e-4 * range.step * factor;
        };
        if (is_whole(range.step) && is_whole(range.smallest)) return digits;
    }
    return most_digits;
}

/// The number of a slider: a stop with the digits that stops need; a value set elsewhere that lies
/// between two stops is written unchanged.
std::string slider_text(float value, const ControlRange& range) {
    const float stop = slider_stop(range, static_cast<double>(value));
    // While it is dragged, it is on its way to that stop.
    const bool is_stop =
        ImGui::IsItemActive() || std::abs(value - stop) < 1e-5f * std::max(std::abs(value), 1e-3f);
    return with_minus_signs(is_stop ? decimals(static_cast<double>(stop), digits_of(range))
                                    : number_text(value));
}

/// The position of a slider's number: in the middle, or next to the handle if that would cover it.
/// @param part  of the range at which the handle is, 0 to 1
/// @param width of the number, screen pixels
float number_position(float part, float width) {
    const float field = ImGui::GetItemRectSize().x, handle = ImGui::GetStyle().GrabMinSize;
    const float middle = 0.5f * handle + part * (field - handle);
    if (std::abs(middle - 0.5f * field) > 0.5f * (width + handle)) return 0.5f;
    return middle < 0.5f * field ? 0.9f : 0.1f;
}

} // namespace

bool drag_number(const char* id, float& value, const DragRange<float>& range) {
    // ImGui rounds to what is shown: three digits would make small steps 0.
    const bool is_fine = range.step < 0.001f;
    return draw_field(
        id,
        [&] {
            return ImGui::DragFloat(id, &value, range.step, range.smallest, range.largest,
                                    is_fine ? "%.7g" : "%.3f", ImGuiSliderFlags_AlwaysClamp);
        },
        [&] { return is_fine ? with_minus_signs(number_text(value)) : fixed(value, 3); });
}

bool drag_number(const char* id, int& value, const DragRange<int>& range, std::string_view label) {
    return draw_field(
        id,
        [&] {
            return ImGui::DragInt(id, &value, range.step, range.smallest, range.largest, "%d",
                                  ImGuiSliderFlags_AlwaysClamp);
        },
        [&] { return std::string(label).append(" ").append(whole_text(value)); });
}

bool slide_number(const char* id, float& value, const ControlRange& range) {
    // ImGui opens a slider for typing by Ctrl and a click; here a double click does it, as in the
    // fields that are dragged.
    ImGuiIO& io = ImGui::GetIO();
    const bool had_ctrl = io.KeyCtrl, was_typed = ImGui::TempInputIsActive(ImGui::GetID(id));
    if (io.MouseDoubleClicked[0] && !was_typed) io.KeyCtrl = true;
    const bool is_changed = draw_field(
        id,
        [&] {
            return ImGui::SliderFloat(id, &value, static_cast<float>(range.smallest),
                                      static_cast<float>(range.largest), "%.7g",
                                      ImGuiSliderFlags_AlwaysClamp);
        },
        [&] { return slider_text(value, range); },
        [&](float width) {
            const auto low = static_cast<float>(range.smallest),
                       high = static_cast<float>(range.largest);
            return number_position(std::clamp((value - low) / (high - low), 0.0f, 1.0f), width);
        });
    io.KeyCtrl = had_ctrl;
    const bool is_typed = was_typed || ImGui::TempInputIsActive(ImGui::GetID(id));
    if (is_changed && !is_typed) value = slider_stop(range, static_cast<double>(value));
    return is_changed;
}

} // namespace rasterwalk
