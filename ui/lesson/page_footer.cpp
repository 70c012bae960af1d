#include "ui/lesson/page_footer.h"

#include <algorithm>
#include <cmath>

#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

int draw_bars(Ui& ui, const PageFooter& footer, float width) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const auto count = static_cast<float>(footer.pages.size());
    const float gap = std::min(6.0f * u, 0.3f * width / count);
    const float bar = std::max((width - gap * (count - 1.0f)) / count, 1.0f);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = 16.0f * u;
    int pressed = -1;
    for (std::size_t i = 0; i < footer.pages.size(); ++i) {
        const PageFooter::Page& page = footer.pages[i];
        const bool is_current = static_cast<int>(i) == footer.current;
        const float x = start.x + static_cast<float>(i) * (bar + gap);
        ImGui::SetCursorScreenPos({x, start.y});
        if (ImGui::InvisibleButton(page.widget.c_str(), {bar, height}))
            pressed = static_cast<int>(i);
        const bool hovered = ImGui::IsItemHovered();
        name_widget(ui, page.widget, page.title);
        const float half = (hovered || is_current ? 3.5f : 2.0f) * u;
        const float middle = start.y + 0.5f * height;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {x, middle - half}, {x + bar, middle + half},
            packed(page.is_seen || is_current ? p.link : p.button), half);
    }
    ImGui::SetCursorScreenPos({start.x, start.y + height});
    return pressed;
}

/// The title beside its arrow, or only the word where it is too long.
std::string fitting_label(const std::string& title, const char* word, float room) {
    return button_width(title + "  ›") <= room ? title : word;
}

} // namespace

float page_footer_height(const Ui& ui) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y +
           26.0f * ui.options.text_scale;
}

int draw_page_footer(Ui& ui, const PageFooter& footer, float width, const std::string& next) {
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    int wanted = draw_bars(ui, footer, width);
    const float y = start.y + 24.0f * u;
    const int last = static_cast<int>(footer.pages.size()) - 1;
    const auto title = [&](int page) -> const std::string& {
        return footer.pages[static_cast<std::size_t>(page)].title;
    };
    // The halves of the line, whatever stands on the buttons: who walks on need not look for them.
    const float gap = 8.0f * u;
    const float half = std::floor(0.5f * (width - gap));
    if (footer.current < last || !next.empty()) {
        std::string label = footer.current < last ? title(footer.current + 1) : next;
        const std::string help = "To the next page: " + label;
        label = fitting_label(label, "next", half) + "  ›";
        ImGui::SetCursorScreenPos({start.x + width - half, y});
        if (button(ui, "lesson.next", label, Look::main, help, {half, 0.0f})) {
            wanted = footer.current + 1;
        }
    }
    // Where there is no way back there is room for the title of what comes.
    if (footer.current == 0 && last > 0) {
        const ImFont* const small = ui.fonts.small;
        ImGui::PushFont(ui.fonts.small);
        const std::string words = shortened(title(1), half);
        ImGui::PopFont();
        const float middle = 0.5f * (ImGui::GetFrameHeight() - small->FontSize);
        ImGui::GetWindowDrawList()->AddText(small, small->FontSize, {start.x, y + middle},
                                            packed(palette(ui.options.theme).dim), words.c_str());
    }
    if (footer.current > 0) {
        const std::string& before = title(footer.current - 1);
        const std::string label = "‹  " + fitting_label(before, "back", half);
        ImGui::SetCursorScreenPos({start.x, y});
        if (button(ui, "lesson.previous", label, Look::plain, "To the page before: " + before,
                   {half, 0.0f})) {
            wanted = footer.current - 1;
        }
    }
    return wanted;
}

} // namespace rasterwalk
