#include "ui/lesson/strip_buttons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/actions/actions.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/lesson/lesson_page.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_drawer_button(Ui& ui, ImVec2 corner) {
    const char* const label = tr(is_drawer_open(ui) ? "▴ close" : "▾ the whole text");
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(2.0f, 1.0f * ui.options.text_scale));
    const float width = button_width(label);
    ImGui::SetCursorScreenPos({corner.x - width, corner.y});
    if (button(ui, "lesson.whole", label, Look::link, tooltip_of("lesson.whole"), {width, 0.0f})) {
        find_action("lesson.whole").run(ui);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

int draw_strip_buttons(Ui& ui, const Lesson* lesson, PageFooter pages, ImVec2 corner) {
    const float u = ui.options.text_scale;
    const LessonView& view = ui.lesson;
    pages.has_more_before = lesson != nullptr && view.has_more_above;
    pages.has_more_after = lesson != nullptr && view.has_more_below;
    if (lesson != nullptr && !is_drawer_open(ui)) {
        pages.has_more_before |= view.strip.card > 0;
        pages.has_more_after |= view.strip.card + 1 < static_cast<int>(view.strip.cards.size());
    }
    ImGui::SetCursorScreenPos({corner.x - page_buttons_width(ui), corner.y});
    const int direction = draw_page_buttons(ui, pages, strip_button_height * u);
    draw_drawer_button(ui, {corner.x, corner.y + (strip_button_height + strip_button_gap) * u});
    return direction;
}

void scroll_by_key(LessonView& view) {
    const float at = ImGui::GetScrollY(), last = ImGui::GetScrollMaxY();
    const float line = ImGui::GetFontSize();
    view.has_more_above = at > 1.0f;
    view.has_more_below = at < last - 1.0f && (view.is_cut_below || last - at > line);
    if (view.pages_to_scroll == 0.0f) return;
    const bool is_on = std::exchange(view.pages_to_scroll, 0.0f) > 0.0f;
    // What is higher than the window moves by at least the line.
    float to = is_on ? std::max(view.shown_to, at + line)
                     : std::min(view.shown_from - ImGui::GetWindowHeight(), at - line);
    // The text does not stop less than a line below its top if no line is left out for that.
    if (!is_on && to < line) to = 0.0f;
    ImGui::SetScrollY(std::clamp(to, 0.0f, last));
}

void record_shown_lines(Ui& ui) {
    const ShownLines shown = shown_lines();
    const float beginning = ImGui::GetWindowPos().y - ImGui::GetScrollY();
    ui.lesson.shown_from = shown.top - beginning;
    ui.lesson.shown_to = shown.bottom - beginning;
    ui.lesson.is_cut_below = is_cut_off();
}

} // namespace rasterwalk
