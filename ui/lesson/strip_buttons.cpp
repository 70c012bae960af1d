#include "ui/lesson/strip_buttons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/actions/actions.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/lesson/lesson_page.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_drawer_button(Ui& ui, ImVec2 corner) {
    const char* const label = is_drawer_open(ui) ? "▴ close" : "▾ the whole text";
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

namespace {

/// Where a key scrolls to.
/// @param pages 1 is one on, -1 one back
float scrolled(float at, float pages, float last) {
    const float line = 1.4f * ImGui::GetFontSize();
    // A line of the page before stays in sight.
    const float most = std::max(ImGui::GetWindowHeight() - line, line);
    const float to = std::clamp(at + pages * std::max(most - line, line), 0.0f, last);
    // Nobody stops for less than a line.
    const float end = pages > 0.0f ? last : 0.0f;
    const bool is_nearly_there = std::abs(end - to) < line && std::abs(end - at) <= most;
    return is_nearly_there ? end : to;
}

} // namespace

void scroll_by_key(LessonView& view) {
    const float at = ImGui::GetScrollY(), last = ImGui::GetScrollMaxY();
    view.has_more_above = at > 1.0f;
    view.has_more_below = at < last - 1.0f;
    if (view.pages_to_scroll == 0.0f) return;
    ImGui::SetScrollY(scrolled(at, std::exchange(view.pages_to_scroll, 0.0f), last));
}

} // namespace rasterwalk
