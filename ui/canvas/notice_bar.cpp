#include "ui/canvas/notice_bar.h"

#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

std::string_view draw_notice_bar(Ui& ui, const char* name, const std::vector<std::string>& forms,
                                 const std::string& help, bool is_true_now,
                                 std::span<const NoticeButton> buttons) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.small);
    const float left = ImGui::GetCursorScreenPos().x;
    const float right = left + ImGui::GetContentRegionAvail().x;
    const auto width_of = [&](std::span<const NoticeButton> some) {
        float width = 0.0f;
        for (const NoticeButton& one : some)
            width += button_width(one.label) + gap;
        return width;
    };
    // The sentence they are for is worth more than the last of them.
    const float least = ImGui::CalcTextSize(forms.back().c_str()).x;
    while (buttons.size() > 1 && least + width_of(buttons) > right - left)
        buttons = buttons.first(buttons.size() - 1);
    const float width = width_of(buttons);
    ImGui::AlignTextToFramePadding();
    const std::string shown = first_fitting(forms, right - width - left);
    text_in(is_true_now ? p.text : p.dim, shown);
    register_widget(ui, name, help, shown);
    float x = right - width + gap;
    std::string_view clicked;
    for (const NoticeButton& one : buttons) {
        ImGui::SameLine();
        ImGui::SetCursorScreenPos({x, ImGui::GetCursorScreenPos().y});
        x += button_width(one.label) + gap;
        if (button(ui, one.name, one.label, Look::plain, one.help)) clicked = one.name;
    }
    ImGui::PopFont();
    return clicked;
}

} // namespace rasterwalk
