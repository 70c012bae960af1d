#include "ui/lesson/lesson_list.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "base/numbers.h"
#include "lessons/lesson_search.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Space around an entry's mark and to the right of its title, design pixels.
constexpr float entry_margin = 8.0f, entry_indent = 30.0f;

/// The room for a title next to the text at its right, screen pixels.
float title_room(const Ui& ui, float width, const std::string& right) {
    const float u = ui.options.text_scale;
    const float beside =
        right.empty() ? 0.0f : text_width(ui.fonts.small, right) + entry_margin * u;
    return width - (entry_indent + entry_margin) * u - beside;
}

/// The text with line breaks so that no line is wider than this in the font, screen pixels.
std::string lines_of(ImFont* font, std::string_view text, float width) {
    ImGui::PushFont(font);
    std::string lines = broken_into_lines(text, width);
    ImGui::PopFont();
    return lines;
}

/// A line of the list that can be pressed: a title, and small text below it.
bool draw_entry(Ui& ui, const std::string& name, const std::string& mark, const ImVec4& mark_colour,
                const std::string& title_text, const std::string& below_text,
                const std::string& right, float width, std::string_view help) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float margin = entry_margin * u, indent = entry_indent * u;
    const float wrap = width - indent - margin;
    ImFont* const font = ui.fonts.text;
    ImFont* const small = ui.fonts.small;
    const float right_width = text_width(small, right);
    const float room = title_room(ui, width, right);
    std::string title;
    if (below_text.empty()) {
        ImGui::PushFont(font);
        title = shortened_to_words(title_text, room); // a line each
        ImGui::PopFont();
    } else {
        title = lines_of(font, title_text, room);
    }
    const std::string below = lines_of(small, below_text, wrap);
    const ImVec2 title_size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, title.c_str());
    const ImVec2 below_size = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, below.c_str());
    const float height = title_size.y + (below.empty() ? 9.0f * u : below_size.y + 17.0f * u);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(name.c_str(), {width, height});
    const bool hovered = ImGui::IsItemHovered();
    register_widget(ui, name, help, title);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (hovered) {
        list->AddRectFilled(low, {low.x + width, low.y + height}, packed(p.row_lit), 4.0f * u);
    }
    const float y = low.y + (below.empty() ? 4.5f : 6.0f) * u;
    list->AddText(font, font->FontSize, {low.x + margin, y}, packed(mark_colour), mark.c_str());
    list->AddText(font, font->FontSize, {low.x + indent, y}, packed(p.text), title.c_str());
    list->AddText(small, small->FontSize, {low.x + width - margin - right_width, y + 2.0f * u},
                  packed(p.dim), right.c_str());
    if (!below.empty()) {
        list->AddText(small, small->FontSize, {low.x + indent, y + title_size.y + 3.0f * u},
                      packed(p.dim), below.c_str());
    }
    return pressed;
}

std::string minutes_text(const Lesson& lesson) {
    return std::to_string(lesson.minutes) + " min";
}

/// Do all titles have room on one line with the minutes? If one does not, none has minutes: they
/// are given with what the lesson is about.
bool has_room_for_minutes(const Ui& ui, const std::vector<Lesson>& lessons, float width) {
    return std::all_of(lessons.begin(), lessons.end(), [&](const Lesson& lesson) {
        return text_width(ui.fonts.text, lesson.title) <=
               title_room(ui, width, minutes_text(lesson));
    });
}

/// The line of a lesson that is not written yet.
void draw_unwritten(Ui& ui, int number) {
    const float u = ui.options.text_scale;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImU32 colour = packed(palette(ui.options.theme).dim);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddText({low.x + entry_margin * u, low.y + 4.5f * u}, colour,
                  std::to_string(number).c_str());
    list->AddText({low.x + entry_indent * u, low.y + 4.5f * u}, colour, "to come");
    ImGui::Dummy({0.0f, ImGui::GetFontSize() + 9.0f * u});
    clip_to_lines();
}

/// What a track is called, how long it takes and what it needs, over its first lesson.
void draw_track(Ui& ui, std::size_t track, float width) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    LessonList& lessons = ui.lesson.lessons;
    const Course& course = lessons.course();
    ImGui::Dummy({0.0f, (track == 0 ? 2.0f : 12.0f) * u});
    const float left = ImGui::GetCursorPosX();
    ImGui::SetCursorPosX(left + entry_margin * u);
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(left + width - entry_margin * u);
    if (track == course.tracks.size()) {
        put_text("Other lessons", ui.fonts.bold);
    } else {
        const Track& shown = course.tracks[track];
        const TrackSize size = size_of_track(course, track, lessons.all());
        const std::string words = fmt::format("{}, {}", counted(size.lessons, "lesson", "lessons"),
                                              hours_text(size.minutes));
        put_text(shown.title, ui.fonts.bold);
        const float gap = 10.0f * u;
        const bool fits =
            text_width(ui.fonts.bold, shown.title) + gap + text_width(ui.fonts.small, words) <
            width - 2.0f * entry_margin * u;
        if (ui.lesson.is_strip && fits) ImGui::SameLine(0.0f, gap);
        text_in(p.dim, words, ui.fonts.small);
        if (!ui.lesson.is_strip) {
            wrapped_text_in(p.dim, shown.about, ui.fonts.small);
            wrapped_text_in(p.dim, "Needs: " + shown.needs, ui.fonts.small);
        }
    }
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    ImGui::Dummy({0.0f, 2.0f * u});
}

void draw_map_link(Ui& ui) {
    if (button(ui, "lesson.map", "map of the course", Look::link,
               "All lessons at a glance, and which of them build on which."))
        ui.sheets.show(Sheet::map);
}

void draw_test_entry(Ui& ui, float width) {
    if (draw_entry(ui, "lesson.test", "?", palette(ui.options.theme).dim,
                   "Test before and after the lessons",
                   ui.lesson.is_strip ? ""
                                      : "What you know before, and what you know after, to hand "
                                        "in.",
                   "", width, "Opens the test.")) {
        ui.sheets.show(Sheet::test);
    }
}

/// The lessons of the course, with their tracks.
void draw_lessons(Ui& ui, float width) {
    const Palette& p = palette(ui.options.theme);
    if (!ui.lesson.lessons.course_fault().empty()) {
        wrapped_text_in(colour_of(Meaning::fail, ui.options.theme),
                        ui.lesson.lessons.course_fault(), ui.fonts.small);
    }
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    // Where lines are few, a lesson has one, and its tooltip has the rest.
    const bool is_short = ui.lesson.is_strip;
    if (!is_short) draw_map_link(ui);
    const bool has_minutes = !is_short || has_room_for_minutes(ui, lessons, width);
    draw_test_entry(ui, width);
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const Lesson& lesson = lessons[i];
        const Course& course = ui.lesson.lessons.course();
        const std::size_t track = place_in(course, lesson.id).track;
        const bool begins = i == 0 || place_in(course, lessons[i - 1].id).track != track;
        if (begins && !course.tracks.empty()) draw_track(ui, track, width);
        if (const int number = missing_number(lessons, i)) draw_unwritten(ui, number);
        const LessonScore score = ui.lesson.scores.of(i);
        const bool is_open = lesson.id == ui.session.lesson;
        const ImVec4 colour = score.is_done ? colour_of(Meaning::pass, ui.options.theme)
                              : is_open     ? p.link
                                            : p.dim;
        std::string right;
        if (score.done > 0 && !score.is_done) {
            right.append(std::to_string(score.done)).append("/");
            right.append(std::to_string(score.all));
        } else if (has_minutes) {
            right = minutes_text(lesson);
        }
        const std::string help =
            is_short ? lesson.title + ", " + minutes_text(lesson) + ".\n" + lesson.about
                     : "Opens this lesson.";
        if (draw_entry(ui, "lesson.item." + lesson.id,
                       score.is_done ? "✓" : std::to_string(lesson_number(lesson.id)), colour,
                       lesson.title, is_short ? "" : lesson.about, right, width, help)) {
            const int step = score.is_done ? 0 : score.last_step;
            open_lesson(ui, std::string(lesson.id), step);
            return;
        }
    }
    ImGui::Dummy({0.0f, 6.0f * ui.options.text_scale});
    if (is_short) draw_map_link(ui);
    if (button(ui, "lesson.reset", "forget all progress", Look::link,
               "Removes every tick and answer; asks first.")) {
        ImGui::OpenPopup("lesson.reset.sure");
    }
    if (ImGui::BeginPopup("lesson.reset.sure")) {
        put_text("Forget what you have done in all lessons?");
        if (button(ui, "lesson.reset.yes", "forget", Look::plain, "This cannot be undone.")) {
            reset_progress(ui);
            ImGui::CloseCurrentPopup();
        }
        ImGui::SameLine();
        if (button(ui, "lesson.reset.no", "keep", Look::main, "Nothing changes.")) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
}

void draw_hits(Ui& ui, float width) {
    const Palette& p = palette(ui.options.theme);
    LessonSearch& found = ui.lesson.found;
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    if (found.query != ui.lesson.search || found.number != ui.lesson.lessons.number()) {
        found = {ui.lesson.search, ui.lesson.lessons.number(),
                 search_lessons(lessons, ui.session.glossary, ui.lesson.search)};
    }
    // The copy outlives the opening of a lesson, which may search again.
    const std::vector<SearchHit> hits = found.hits;
    if (hits.empty()) {
        text_in(p.dim, "Nothing was found.");
        return;
    }
    int number = 0;
    for (const SearchHit& hit : hits) {
        const std::string name = "lesson.hit." + std::to_string(number++);
        const bool is_term = hit.lesson.empty();
        const std::string mark = is_term ? "§" : std::to_string(lesson_number(hit.lesson));
        if (!draw_entry(ui, name, mark, p.link, hit.title, hit.excerpt, is_term ? "glossary" : "",
                        width,
                        is_term ? "Opens the glossary." : "Opens the lesson at this step.")) {
            continue;
        }
        if (is_term) {
            ui.sheets.show(Sheet::glossary);
            ui.sheets.search_of(Sheet::glossary) = hit.title;
        } else {
            open_lesson(ui, hit.lesson, hit.step);
        }
    }
}

} // namespace

void draw_lesson_list(Ui& ui, float width) {
    ImGui::SetNextItemWidth(width);
    ImGui::InputTextWithHint("##search", "search lessons and glossary", &ui.lesson.search);
    register_widget(ui, "lesson.search", "Finds words in all lessons and in the glossary.");
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
    if (ui.lesson.search.empty()) {
        draw_lessons(ui, width);
    } else {
        draw_hits(ui, width);
    }
}

} // namespace rasterwalk
