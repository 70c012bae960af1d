#include "ui/lesson/lesson_strip.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/actions/open_lesson.h"
#include "ui/lesson/fitting_sentences.h"
#include "ui/lesson/lesson_box.h"
#include "ui/lesson/lesson_cards.h"
#include "ui/lesson/lesson_controls.h"
#include "ui/lesson/lesson_page.h"
#include "ui/lesson/lesson_predictions.h"
#include "ui/lesson/lesson_puzzles.h"
#include "ui/lesson/lesson_tasks.h"
#include "ui/lesson/stage_page.h"
#include "ui/lesson/strip_buttons.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: space between text and buttons, and height of the first line.
constexpr float middle_gap = 16.0f;
constexpr float head_height = 25.0f;
constexpr float narrow_head_height = 66.0f;
constexpr float word_height = 21.0f;

/// Width of the bars in the first line, design pixels; below the least they are left out.
constexpr float bars_width = 120.0f;
constexpr float least_bars = 50.0f;

/// Height of the first line or, in a narrow strip, of the buttons; screen pixels, whole, so that
/// the text below it begins at a pixel.
float head_room(const Ui& ui) {
    const LessonStrip& strip = ui.lesson.strip;
    const float words = strip.has_long_words ? word_height + 4.0f : 0.0f;
    const float height = strip.is_at_side ? narrow_head_height + words : head_height;
    return std::round(height * ui.options.text_scale);
}

/// What the first line says.
struct Head {
    std::string title;
    std::string place; ///< "step 3 of 7"
    PageFooter pages;
};

/// Title, place and bars, and room for the words of the step's parts. Returns the page whose bar
/// was pressed, or -1.
/// @param words has the size of these words; gets their place
int draw_head(Ui& ui, const Head& head, float width, Area& words) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float gap = 12.0f * u, height = word_height * u;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImFont* const small = ui.fonts.small;
    const float place = text_width(small, head.place);
    ImGui::PushFont(ui.fonts.bold);
    const float whole = text_width(head.title);
    ImGui::PopFont();
    // The bars give way to the title.
    const float bars =
        std::min({bars_width * u, 0.25f * width, width - whole - words.size.x - 2.0f * gap});
    const bool has_bars = bars >= least_bars * u;
    const float right = start.x + width - (has_bars ? bars + gap : 0.0f);
    const float left = right - words.size.x;
    const float room = std::max(left - start.x - gap, 0.0f);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const auto write = [&](const ImFont* font, float x, const ImVec4& colour,
                           const std::string& text) {
        list->AddText(font, font->FontSize, {x, start.y + 0.5f * (height - font->FontSize)},
                      packed(colour), text.c_str());
    };
    ImGui::PushFont(ui.fonts.bold);
    const std::string title = shortened(head.title, room);
    const float end = start.x + text_width(title);
    write(ui.fonts.bold, start.x, p.text, title);
    ImGui::PopFont();
    if (end + 2.0f * gap + place <= left) write(small, end + gap, p.dim, head.place);
    words.position = {left, start.y};
    int wanted = -1;
    if (has_bars) {
        ImGui::SetCursorScreenPos(
            {start.x + width - bars, start.y + 0.5f * (height - page_bars_height(ui))});
        wanted = draw_page_bars(ui, head.pages, bars);
    }
    ImGui::SetCursorScreenPos({start.x, start.y + head_room(ui)});
    return wanted;
}

/// The card has its own window, which scrolls below the head.
void begin_card_window(float width) {
    const float scroll_bar = ImGui::GetStyle().ScrollbarSize;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("lesson.strip.text", {width + scroll_bar, 0.0f}, false,
                      ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    ImGui::PushTextWrapPos(width);
    begin_line_clip();
}

void end_card_window(Ui& ui) {
    record_shown_lines(ui);
    end_line_clip();
    ImGui::PopTextWrapPos();
    const float card = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    ui.lesson.strip.height = head_room(ui) + card;
    ImGui::EndChild();
}

/// Some lines of a text.
void draw_text_card(Ui& ui, const MarkdownDocument& page, float width) {
    draw_marked(ui, "lesson.strip", ui.lesson.pages["strip"], page, width);
}

void draw_card(Ui& ui, const Lesson& lesson, const LessonStep& step, const LessonCard& card,
               float width) {
    if (ui.lesson.strip.card == 0) draw_lesson_faults(ui, lesson);
    using Kind = LessonPart::Kind;
    const auto part = static_cast<std::size_t>(card.part);
    const int first = card_of_part(ui.lesson.strip, card.part);
    // A reason continues from the question's own card.
    if (part >= step.parts.size() || step.parts[part].kind == Kind::text ||
        step.parts[part].kind == Kind::control || ui.lesson.strip.card > first) {
        draw_text_card(ui, card.page, width);
        return;
    }
    const auto index = static_cast<std::size_t>(step.parts[part].index);
    if (step.parts[part].kind == Kind::task) {
        draw_task_lines(ui, lesson, lesson.tasks[index], width);
    } else if (step.parts[part].kind == Kind::puzzle) {
        draw_puzzle_lines(ui, lesson, lesson.puzzles[index], width);
    } else {
        draw_prediction_lines(ui, lesson, lesson.predictions[index], card.page, width);
    }
}

/// Draws the controls below the last card of their part.
void draw_controls(Ui& ui, const Lesson& lesson, const LessonStep& step, float width) {
    const LessonStrip& strip = ui.lesson.strip;
    const auto card = static_cast<std::size_t>(strip.card);
    if (card >= strip.cards.size()) return; // a link has led elsewhere
    const int part = strip.cards[card].part;
    if (card + 1 < strip.cards.size() && strip.cards[card + 1].part == part) return;
    for (const LessonControl* const control : controls_of_part(lesson, step, part))
        draw_lesson_control(ui, *control, width);
}

/// Returns the page to which a bar leads, or -1.
/// @param head_width without the buttons
int draw_lesson_text(Ui& ui, const Lesson& lesson, const PageFooter& pages, float head_width,
                     float width) {
    const LessonStep& step = shown_step(ui, lesson);
    const Head head{heading_text(step), place_in_lesson(ui, lesson), pages};
    LessonStrip& strip = ui.lesson.strip;
    const float margins = 2.0f * strip_margin_y * ui.options.text_scale;
    const float room = strip.most_height - margins - head_room(ui);
    strip.figure_height = std::max(room - 4.0f * ui.options.text_scale, 1.0f);
    cut_cards(ui, lesson, step, width, room);
    const int part = strip.cards[static_cast<std::size_t>(strip.card)].part;
    Area words{{}, {part_words_width(ui, lesson, step, part), word_height * ui.options.text_scale}};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    // In a narrow strip the words have their own line, next to the buttons or below them.
    strip.has_long_words = words.size.x > head_width;
    Area none;
    const int wanted = draw_head(ui, head, head_width, strip.is_at_side ? none : words);
    const ImVec2 below = ImGui::GetCursorScreenPos();
    if (strip.is_at_side) {
        const float above = strip.has_long_words ? narrow_head_height : head_height;
        words.position = {start.x, start.y + std::round(above * ui.options.text_scale)};
    }
    const int pressed = draw_part_words(ui, lesson, step, part, words);
    if (pressed >= 0) strip.card = card_of_part(strip, pressed);
    ImGui::SetCursorScreenPos(below);
    begin_card_window(width);
    if (strip.card != strip.scrolled_card) {
        ImGui::SetScrollY(0.0f);
        ui.lesson.pages_to_scroll = 0.0f;
    }
    strip.scrolled_card = strip.card;
    scroll_by_key(ui.lesson);
    // A copy: a link in it may lead to another step.
    const LessonCard card = strip.cards[static_cast<std::size_t>(strip.card)];
    const std::string name = ui.session.lesson;
    const int number = ui.session.step;
    draw_card(ui, lesson, step, card, width);
    if (ui.session.lesson == name && ui.session.step == number)
        draw_controls(ui, lesson, step, width);
    end_card_window(ui);
    strip.figure_height = 0.0f;
    return wanted;
}

int draw_stage(Ui& ui, const PageFooter& pages, float head_width, float width) {
    const StageInfo& info = stage_info(ui.session.a.settings);
    const Head head{std::string(info.title), tr("stage {} of {}", pages.current + 1, stage_count),
                    pages};
    Area words{};
    const int wanted = draw_head(ui, head, head_width, words);
    begin_card_window(width);
    scroll_by_key(ui.lesson);
    const StageNote& note = ui.lesson.notes.find(note_name(ui.session));
    const std::string text = note.fault.empty() ? shown_note(ui, note) : std::string(info.summary);
    // The button forward leads to the next stage: what has no room is left to the whole text.
    draw_text_card(ui, fitting_sentences(ui, text, width, lines_of_strip(ui)), width);
    end_card_window(ui);
    return wanted;
}

} // namespace

float lesson_strip_height(const Ui& ui) {
    const float line = std::round(1.4f * ui.fonts.text->FontSize);
    const float u = ui.options.text_scale;
    const float two_lines = head_room(ui) + static_cast<float>(lines_of_strip(ui)) * line;
    return std::ceil(std::max(two_lines, ui.lesson.strip.height) + 2.0f * strip_margin_y * u);
}

void draw_lesson_strip(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14.0f * u, strip_margin_y * u));
    ImGui::Begin("lesson strip", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    const float bottom = area.position.y + area.size.y - 0.5f;
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    ImGui::PushClipRect(area.position, end, false);
    ImGui::GetWindowDrawList()->AddLine({area.position.x, bottom}, {end.x, bottom}, packed(p.line));
    ImGui::PopClipRect();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float buttons = page_buttons_width(ui);
    const float head = std::max(room.x - buttons - middle_gap * u, 1.0f);
    const float text = ui.lesson.strip.is_at_side ? room.x : head;

    const Lesson* const open = open_lesson_of(ui);
    const Lesson* const lesson = ui.session.page != SidePage::stage ? open : nullptr;
    const PageFooter pages = lesson != nullptr ? pages_of_lesson(ui, *lesson) : pages_of_stages(ui);

    const float width = std::max(text - ImGui::GetStyle().ScrollbarSize, 1.0f);
    const int bar = lesson != nullptr ? draw_lesson_text(ui, *lesson, pages, head, width)
                                      : draw_stage(ui, pages, head, width);
    const int direction = draw_strip_buttons(ui, lesson, pages, {start.x + room.x, start.y});
    ImGui::End();
    ImGui::PopStyleVar();
    if (lesson == nullptr) {
        turn_to_stage(ui, direction != 0 ? pages.current + direction : bar);
    } else if (direction != 0) {
        turn_in_lesson(ui, *lesson, direction);
    } else {
        turn_to_step(ui, *lesson, bar);
    }
}

} // namespace rasterwalk
