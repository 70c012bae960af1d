#include "ui/lesson/page_footer.h"

#include <algorithm>
#include <cmath>

#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

float page_bars_height(const Ui& ui) {
    return 16.0f * ui.options.text_scale;
}

int draw_page_bars(Ui& ui, const PageFooter& footer, float width) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const auto count = static_cast<float>(footer.pages.size());
    const float gap = std::min(6.0f * u, 0.3f * width / count);
    const float bar = std::max((width - gap * (count - 1.0f)) / count, 1.0f);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = page_bars_height(ui);
    int pressed = -1;
    for (std::size_t i = 0; i < footer.pages.size(); ++i) {
        const PageFooter::Page& page = footer.pages[i];
        const bool is_current = static_cast<int>(i) == footer.current;
        const float x = start.x + static_cast<float>(i) * (bar + gap);
        ImGui::SetCursorScreenPos({x, start.y});
        if (ImGui::InvisibleButton(page.widget.c_str(), {bar, height}))
            pressed = static_cast<int>(i);
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, page.widget, page.title);
        const float half = (hovered || is_current ? 3.5f : 2.0f) * u;
        const float middle = start.y + 0.5f * height;
        ImGui::GetWindowDrawList()->AddRectFilled(
            {x, middle - half}, {x + bar, middle + half},
            packed(page.is_seen || is_current ? p.link : p.button), half);
    }
    ImGui::SetCursorScreenPos({start.x, start.y + height});
    return pressed;
}

namespace {

/// The title next to its arrow, or only the word if the title is too long.
std::string fitting_label(const std::string& title, const char* word, float room) {
    return button_width(title + "  ›") <= room ? title : word;
}

/// The title of a page; beyond the last, the name of what follows.
const std::string& title_of(const PageFooter& footer, int page) {
    const auto index = static_cast<std::size_t>(std::max(page, 0));
    return index < footer.pages.size() ? footer.pages[index].title : footer.beyond;
}

bool has_next(const PageFooter& footer) {
    return footer.has_more_after || footer.open_below != PageFooter::Open::nothing ||
           footer.current + 1 < static_cast<int>(footer.pages.size()) || !footer.beyond.empty();
}

bool has_previous(const PageFooter& footer) {
    return footer.has_more_before || footer.current > 0;
}

std::string next_help(const PageFooter& footer) {
    switch (footer.open_below) {
    case PageFooter::Open::question:
        return tr("Scrolls to the question. Answer it first, then go on.");
    case PageFooter::Open::task:
        return tr("Scrolls to the task. Do it before you go on.");
    case PageFooter::Open::nothing:
        break;
    }
    return footer.has_more_after
               ? tr("Shows the next part of this step.")
               : tr("Goes to the next page: {}", title_of(footer, footer.current + 1));
}

bool draw_next(Ui& ui, const PageFooter& footer, const std::string& label, ImVec2 size) {
    return button(ui, "lesson.next", label, Look::main, next_help(footer), size);
}

bool draw_previous(Ui& ui, const PageFooter& footer, const std::string& label, ImVec2 size) {
    return button(ui, "lesson.previous", label, Look::plain,
                  footer.has_more_before
                      ? tr("Shows the previous part of this step.")
                      : tr("Goes to the previous page: {}", title_of(footer, footer.current - 1)),
                  size);
}

/// The label of the forward button in a footer.
std::string next_label(const PageFooter& footer, float room) {
    if (footer.open_below != PageFooter::Open::nothing) {
        const bool is_task = footer.open_below == PageFooter::Open::task;
        const std::string word = fitting_label(tr(is_task ? "task" : "question"), tr("next"), room);
        return fitting_label(tr(is_task ? "to the task" : "to the question"), word.c_str(), room) +
               "  ▾";
    }
    return fitting_label(title_of(footer, footer.current + 1), tr("next"), room) + "  ›";
}

/// Widths of the buttons in a strip, design pixels.
constexpr float next_width = 86.0f;
constexpr float previous_width = 40.0f;

} // namespace

float page_footer_height(const Ui& ui) {
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y +
           26.0f * ui.options.text_scale;
}

PageRequest draw_page_footer(Ui& ui, const PageFooter& footer, float width) {
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    PageRequest request{draw_page_bars(ui, footer, width)};
    const float y = start.y + 24.0f * u;
    // Each button has half of the line, whatever its label, so walking on needs no searching.
    const float gap = 8.0f * u;
    const float half = std::floor(0.5f * (width - gap));
    if (has_next(footer)) {
        ImGui::SetCursorScreenPos({start.x + width - half, y});
        if (draw_next(ui, footer, next_label(footer, half), {half, 0.0f})) request.direction = 1;
    }
    // If there is no way back, there is room for the title of what comes.
    const std::string& next = title_of(footer, footer.current + 1);
    if (footer.current == 0 && has_next(footer) && fitting_label(next, "", half).empty()) {
        const ImFont* const small = ui.fonts.small;
        ImGui::PushFont(ui.fonts.small);
        const std::string words = shortened(next, half);
        ImGui::PopFont();
        const float middle = 0.5f * (ImGui::GetFrameHeight() - small->FontSize);
        ImGui::GetWindowDrawList()->AddText(small, small->FontSize, {start.x, y + middle},
                                            packed(palette(ui.options.theme).dim), words.c_str());
    }
    if (footer.current > 0) {
        const std::string label =
            "‹  " + fitting_label(title_of(footer, footer.current - 1), tr("back"), half);
        ImGui::SetCursorScreenPos({start.x, y});
        if (draw_previous(ui, footer, label, {half, 0.0f})) request.direction = -1;
    }
    return request;
}

float page_buttons_width(const Ui& ui) {
    return (next_width + previous_width + 6.0f) * ui.options.text_scale;
}

int draw_page_buttons(Ui& ui, const PageFooter& footer, float height) {
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    int direction = 0;
    if (has_previous(footer) && draw_previous(ui, footer, "‹", {previous_width * u, height})) {
        direction = -1;
    }
    ImGui::SetCursorScreenPos({start.x + (previous_width + 6.0f) * u, start.y});
    if (has_next(footer) &&
        draw_next(ui, footer, tr("next") + std::string("  ›"), {next_width * u, height})) {
        direction = 1;
    }
    return direction;
}

} // namespace rasterwalk
