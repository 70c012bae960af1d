#include "ui/lesson/page_footer.h"

#include <algorithm>

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

/// The title between its arrow, or only the word where it is too long.
std::string short_label(const std::string& title, const char* word, float room) {
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
    const auto title = [&](int page) { return footer.pages[static_cast<std::size_t>(page)].title; };
    float room = width;
    if (footer.current < last || !next.empty()) {
        std::string label = footer.current < last
                                ? short_label(title(footer.current + 1), "next", 0.68f * width)
                                : next;
        label += "  ›";
        room -= button_width(label) + 8.0f * u;
        ImGui::SetCursorScreenPos({start.x + width - button_width(label), y});
        if (button(ui, "lesson.next", label, Look::main, "To the next page.")) {
            wanted = footer.current + 1;
        }
    }
    if (footer.current > 0) {
        std::string label = "‹  ";
        label += short_label(title(footer.current - 1), "back", room);
        ImGui::SetCursorScreenPos({start.x, y});
        if (button(ui, "lesson.previous", label, Look::plain, "To the page before.")) {
            wanted = footer.current - 1;
        }
    }
    return wanted;
}

} // namespace rasterwalk
