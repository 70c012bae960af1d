#include "ui/lesson/lesson_column.h"

#include <algorithm>

#include "ui/actions/open_lesson.h"
#include "ui/lesson/lesson_cards.h"
#include "ui/lesson/lesson_list.h"
#include "ui/lesson/lesson_page.h"
#include "ui/lesson/page_footer.h"
#include "ui/lesson/stage_page.h"
#include "ui/lesson/strip_buttons.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

SidePage shown_page(const Ui& ui, const Lesson* lesson) {
    const SidePage page = ui.session.page;
    return page == SidePage::lesson && lesson == nullptr ? SidePage::stage : page;
}

/// Text that continues below has a line at its edge.
void draw_edge(const Ui& ui, float width) {
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) return;
    const ImVec2 low = ImGui::GetWindowPos();
    const float bottom = low.y + ImGui::GetWindowHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, bottom - 1.0f}, {low.x + width, bottom},
                                              packed(palette(ui.options.theme).line));
}

/// The three pages side by side: small words, with the current one underlined.
void draw_switch(Ui& ui, const Lesson* lesson, float width) {
    struct Choice {
        const char* widget;
        const char* title;
        const char* help;
        SidePage page;
    };
    static constexpr Choice choices[] = {
        {"lesson.open", "Lesson", "The lesson that is open.", SidePage::lesson},
        {"lesson.stage", "This stage", "A page about the stage that the picture shows.",
         SidePage::stage},
        {"lesson.list", "All lessons", "The lessons, your progress, and a search.",
         SidePage::list}};
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const SidePage shown = shown_page(ui, lesson);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::PushFont(ui.fonts.small);
    const float height = ImGui::GetFontSize() + 10.0f * u;
    float x = start.x;
    for (const Choice& choice : choices) {
        if (choice.page == SidePage::lesson && lesson == nullptr) continue;
        const float text = std::max(ImGui::CalcTextSize(tr(choice.title)).x, 1.0f);
        ImGui::SetCursorScreenPos({x, start.y});
        if (ImGui::InvisibleButton(choice.widget, {text, height})) {
            ui.session.page = choice.page;
        }
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, choice.widget, tr(choice.help));
        const bool is_shown = shown == choice.page;
        ImDrawList* const list = ImGui::GetWindowDrawList();
        list->AddText({x, start.y + 3.0f * u}, packed(is_shown || hovered ? p.text : p.dim),
                      tr(choice.title));
        if (is_shown) {
            list->AddRectFilled({x, start.y + height - 2.0f * u}, {x + text, start.y + height},
                                packed(p.link));
        }
        x += text + 16.0f * u;
    }
    ImGui::PopFont();
    ImGui::GetWindowDrawList()->AddRectFilled(
        {start.x, start.y + height}, {start.x + width, start.y + height + 1.0f}, packed(p.line));
    ImGui::SetCursorScreenPos({start.x, start.y + height + 9.0f * u});
}

std::string name_of_page(Ui& ui, const Lesson* lesson, SidePage page) {
    if (page == SidePage::list) return "list";
    if (page == SidePage::stage) return stage_page_name(ui);
    return lesson->id + "/" + std::to_string(ui.session.step);
}

void draw_text(Ui& ui, const Lesson* lesson, SidePage page, float width) {
    if (page == SidePage::lesson) draw_step_text(ui, *lesson, width);
    if (page == SidePage::stage) draw_stage_text(ui, width);
    if (page == SidePage::list) draw_lesson_list(ui, width);
}

void draw_footer(Ui& ui, const Lesson* lesson, SidePage page, float width) {
    if (page == SidePage::lesson) draw_step_footer(ui, *lesson, width);
    if (page == SidePage::stage) draw_stage_footer(ui, width);
}

/// Called in the text's window: the text stays where the student is reading. If it moves to another
/// part of the window, as when both views are shown, it is scrolled to the same share of its length
/// there.
/// @param from_end a new page is shown from its end
void keep_place(LessonView& view, const std::string& page, bool from_end) {
    // The length of the text there is not known until it is laid out.
    constexpr int frames_to_lay_out = 3;
    const ImGuiID place = ImGui::GetID("place");
    const float last = ImGui::GetScrollMaxY();
    scroll_by_key(view);
    if (view.shown != page) {
        view.shown = page;
        view.known_scroll.reset();
        view.frames_to_scroll = from_end ? frames_to_lay_out : 0;
        view.scroll_share = from_end ? 1.0f : 0.0f;
        ImGui::SetScrollY(0.0f);
    } else if (view.place != place) {
        view.frames_to_scroll = frames_to_lay_out;
    }
    view.place = place;
    if (view.frames_to_scroll > 0) {
        --view.frames_to_scroll;
        ImGui::SetScrollY(view.scroll_share * last);
    } else if (last > 0.0f) {
        view.scroll_share = ImGui::GetScrollY() / last;
    }
}

/// The text of a page, which scrolls, with its footer below the text if that is asked for.
void draw_scrolled(Ui& ui, const Lesson* lesson, SidePage page, ImVec2 size, float width,
                   bool has_footer) {
    ImGui::BeginChild("lesson.text", size, false, ImGuiWindowFlags_NoNav);
    const std::string name = name_of_page(ui, lesson, page);
    keep_place(ui.lesson, name, page == SidePage::lesson && ui.lesson.wants_end);
    begin_line_clip();
    draw_text(ui, lesson, page, width);
    if (has_footer) draw_footer(ui, lesson, page, width);
    record_shown_lines(ui);
    end_line_clip();
    draw_edge(ui, width);
    ImGui::EndChild();
}

/// @param gutter space for the scroll bar at the right of the text
void draw_page(Ui& ui, float gutter) {
    const Lesson* const lesson = open_lesson_of(ui);
    const SidePage page = shown_page(ui, lesson);
    const float width = std::max(ImGui::GetContentRegionAvail().x - gutter, 1.0f);
    draw_switch(ui, lesson, width);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool has_footer = page != SidePage::list;
    // In a low window the footer scrolls with the text.
    const bool is_low = has_footer && room.y < 4.5f * page_footer_height(ui);
    const float footer = has_footer && !is_low ? page_footer_height(ui) : 0.0f;
    draw_scrolled(ui, lesson, page, {room.x, std::max(room.y - footer, 1.0f)}, width, is_low);
    if (has_footer && !is_low) draw_footer(ui, lesson, page, width);
}

/// The parts of the step, and which step it is.
void draw_drawer_head(Ui& ui, const Lesson& lesson, const Area& area) {
    const LessonStep& step = shown_step(ui, lesson);
    const int part = draw_part_words(ui, lesson, step, -1, area);
    if (part >= 0) {
        ui.lesson.place_to_show = ui.lesson.strip.read_to = LessonPlace{part};
        ui.lesson.wants_end = false;
    }
    const std::string place = place_in_lesson(ui, lesson);
    const ImFont* const small = ui.fonts.small;
    const float width = text_width(small, place);
    const float words = part_words_width(ui, lesson, step, -1);
    if (words + width > area.size.x) return;
    const ImVec2 at{area.position.x + words,
                    area.position.y + 0.5f * (area.size.y - small->FontSize)};
    ImGui::GetWindowDrawList()->AddText(small, small->FontSize, at,
                                        packed(palette(ui.options.theme).dim), place.c_str());
}

} // namespace

void draw_lesson_column(Ui& ui, const Area& area) {
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const float padding = ImGui::GetStyle().WindowPadding.x;
    // The scroll bar is in the column's right margin.
    ImGui::SetNextWindowContentSize({area.size.x - padding, 0.0f});
    ImGui::Begin("lesson", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    draw_page(ui, padding);
    ImGui::End();
}

void draw_lesson_drawer(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14.0f * u, strip_margin_y * u));
    ImGui::Begin("lesson drawer", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    const Lesson* const lesson = open_lesson_of(ui);
    const SidePage page = shown_page(ui, lesson);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // The list has no pages to turn: its tabs come first.
    const float row = page == SidePage::list ? 0.0f : strip_button_height * u;
    const float below = start.y + (row > 0.0f ? row + strip_button_gap * u : 0.0f);
    if (page == SidePage::lesson) {
        draw_drawer_head(ui, *lesson, {start, {room.x - page_buttons_width(ui), row}});
    }
    const PageFooter pages =
        page == SidePage::lesson ? pages_of_lesson(ui, *lesson) : pages_of_stages(ui);
    const Lesson* const shown = page == SidePage::lesson ? lesson : nullptr;
    int direction = 0;
    if (page == SidePage::list) {
        draw_drawer_button(ui, {start.x + room.x, below});
    } else {
        direction = draw_strip_buttons(ui, shown, pages, {start.x + room.x, start.y});
    }
    ImGui::SetCursorScreenPos({start.x, below});
    draw_switch(ui, lesson, room.x);
    const float gutter = ImGui::GetStyle().ScrollbarSize + 2.0f * u;
    draw_scrolled(ui, lesson, page, ImGui::GetContentRegionAvail(), std::max(room.x - gutter, 1.0f),
                  false);
    ImGui::End();
    ImGui::PopStyleVar();
    if (direction == 0) return;
    if (shown != nullptr) {
        turn_in_lesson(ui, *shown, direction);
    } else {
        turn_to_stage(ui, pages.current + direction);
    }
}

} // namespace rasterwalk
