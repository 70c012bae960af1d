#include "ui/lesson/lesson_strip.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lessons/lesson_search.h"
#include "ui/actions/actions.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/lesson/fitting_sentences.h"
#include "ui/lesson/lesson_page.h"
#include "ui/lesson/lesson_questions.h"
#include "ui/lesson/stage_page.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr int text_card = -1;

/// Design pixels: above and below, between text and buttons, and of the first line.
constexpr float margin_y = 8.0f;
constexpr float middle_gap = 16.0f;
constexpr float head_height = 25.0f;
constexpr float button_height = 36.0f;

/// Of the bars in the first line, design pixels; narrower than the least they are left out.
constexpr float bars_width = 120.0f;
constexpr float least_bars = 50.0f;

/// What the first line says.
struct Head {
    std::string title;
    std::string place; ///< "step 3 of 7"
    PageFooter pages;
};

/// What can be shown of a step: its text, its questions and tasks.
struct Card {
    int part = text_card;
    std::string name;  ///< of the widget
    std::string title; ///< a word, with a sign where it is done
    const char* help = "";
};

const LessonPart* part_of(const LessonStep& step, int card) {
    const bool is_part = card >= 0 && card < static_cast<int>(step.parts.size());
    return is_part ? &step.parts[static_cast<std::size_t>(card)] : nullptr;
}

bool is_open_question(Ui& ui, const Lesson& lesson, const LessonPart& part) {
    if (part.kind != LessonPart::Kind::prediction) return false;
    const LessonPrediction& prediction = lesson.predictions[static_cast<std::size_t>(part.index)];
    take_up_answer(ui, lesson, prediction);
    return !ui.lesson.predictions[prediction.id].judged;
}

/// The card on show: what was asked for, or the first question that is open, or the text. Beside
/// the whole text, which has the questions, always the text.
int card_on_show(Ui& ui, const Lesson& lesson, const LessonStep& step) {
    if (is_drawer_open(ui)) return text_card;
    const std::optional<int>& asked = ui.lesson.strip.card;
    if (asked) return part_of(step, *asked) != nullptr ? *asked : text_card;
    for (std::size_t i = 0; i < step.parts.size(); ++i) {
        if (is_open_question(ui, lesson, step.parts[i])) return static_cast<int>(i);
    }
    return text_card;
}

std::string sign_of(Ui& ui, const Lesson& lesson, const LessonPart& part) {
    const auto index = static_cast<std::size_t>(part.index);
    if (part.kind == LessonPart::Kind::task) {
        return ui.lesson.progress.is_task_done(lesson.id, lesson.tasks[index].id) ? "✓ " : "";
    }
    const PredictionView& view = ui.lesson.predictions[lesson.predictions[index].id];
    return !view.judged ? "" : view.judged->is_right ? "✓ " : "✗ ";
}

/// Nothing where a step has only text.
std::vector<Card> cards_of(Ui& ui, const Lesson& lesson, const LessonStep& step) {
    std::vector<Card> cards;
    const auto count_of = [&](LessonPart::Kind kind) {
        return std::count_if(step.parts.begin(), step.parts.end(),
                             [&](const LessonPart& part) { return part.kind == kind; });
    };
    int questions = 0, tasks = 0;
    for (std::size_t i = 0; i < step.parts.size(); ++i) {
        const LessonPart& part = step.parts[i];
        if (part.kind == LessonPart::Kind::text) continue;
        const bool is_task = part.kind == LessonPart::Kind::task;
        int& number = is_task ? tasks : questions;
        ++number;
        std::string title = sign_of(ui, lesson, part) + (is_task ? "task" : "question");
        if (count_of(part.kind) > 1) title += " " + std::to_string(number);
        cards.push_back({static_cast<int>(i), "lesson.card." + std::to_string(i), title,
                         is_task ? "Something to do." : "Answer first; then the program shows."});
    }
    if (!cards.empty()) {
        cards.insert(cards.begin(),
                     {text_card, "lesson.card.text", "text", "What the step says first."});
    }
    return cards;
}

float cards_width(const Ui& ui, const std::vector<Card>& cards) {
    float width = 0.0f;
    ImGui::PushFont(ui.fonts.small);
    for (const Card& card : cards)
        width += text_width(card.title) + 14.0f * ui.options.text_scale;
    ImGui::PopFont();
    return width;
}

/// Words that can be pressed, the one on show underlined.
void draw_cards(Ui& ui, const std::vector<Card>& cards, int shown, ImVec2 at, float height) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    for (const Card& card : cards) {
        const float width = text_width(card.title);
        ImGui::SetCursorScreenPos(at);
        if (ImGui::InvisibleButton(card.name.c_str(), {width, height})) {
            ui.lesson.strip.card = card.part;
        }
        const bool hovered = ImGui::IsItemHovered();
        name_widget(ui, card.name, card.help);
        const bool is_shown = card.part == shown;
        ImDrawList* const list = ImGui::GetWindowDrawList();
        list->AddText({at.x, at.y + 0.5f * (height - ImGui::GetFontSize())},
                      packed(is_shown || hovered ? p.text : p.link), card.title.c_str());
        if (is_shown) {
            const float bottom = at.y + height - 1.0f * u;
            list->AddRectFilled({at.x, bottom - 2.0f * u}, {at.x + width, bottom}, packed(p.link));
        }
        at.x += width + 14.0f * u;
    }
    ImGui::PopFont();
}

/// Title, place, what the step has, and its bars. Returns the page whose bar was pressed, or -1.
int draw_head(Ui& ui, const Head& head, const std::vector<Card>& cards, int shown, float width) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float gap = 12.0f * u, height = head_height * u - 4.0f * u;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImFont* const small = ui.fonts.small;
    const float place = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, head.place.c_str()).x;
    const float words = cards_width(ui, cards);
    const float bars = std::min(bars_width * u, 0.25f * width);
    const bool has_bars = bars >= least_bars * u;
    const float right = start.x + width - (has_bars ? bars + gap : 0.0f);
    const float left = right - words;
    const float room = std::max(left - start.x - place - 2.0f * gap, 0.0f);
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
    if (end + gap + place <= left) write(small, end + gap, p.dim, head.place);
    draw_cards(ui, cards, shown, {left, start.y}, height);
    int wanted = -1;
    if (has_bars) {
        ImGui::SetCursorScreenPos(
            {start.x + width - bars, start.y + 0.5f * (height - page_bars_height(ui))});
        wanted = draw_page_bars(ui, head.pages, bars);
    }
    ImGui::SetCursorScreenPos({start.x, start.y + head_height * u});
    return wanted;
}

void draw_sentences(Ui& ui, const std::string& text, float width) {
    const std::string fitting = fitting_sentences(ui, text, width, lines_of_strip);
    if (fitting.empty()) return;
    std::shared_ptr<MarkdownPage>& page = ui.lesson.pages["strip"];
    const MarkdownEvents events =
        draw_markdown(ui, page, fitting, width, "lesson.strip.link.", ui.session.lesson_folder);
    answer_links(ui, document_of(*page), events);
}

/// The text with which a step begins; of a step that begins otherwise, what the lesson is about.
std::string text_of(const Lesson& lesson, const LessonStep& step) {
    for (const LessonPart& part : step.parts) {
        if (part.kind == LessonPart::Kind::text) return part.text;
    }
    return lesson.about;
}

void draw_card(Ui& ui, const Lesson& lesson, const LessonStep& step, int card, float width) {
    const LessonPart* const part = part_of(step, card);
    if (part == nullptr || part->kind == LessonPart::Kind::text) {
        if (!is_drawer_open(ui)) draw_lesson_faults(ui, lesson);
        draw_sentences(ui, text_of(lesson, step), width);
        return;
    }
    const auto index = static_cast<std::size_t>(part->index);
    if (part->kind == LessonPart::Kind::task) {
        draw_task_lines(ui, lesson, lesson.tasks[index], width);
        return;
    }
    const std::pair place{ui.session.lesson, ui.session.step};
    draw_prediction_lines(ui, lesson, lesson.predictions[index], width);
    // A link in it may lead elsewhere.
    if (std::pair{ui.session.lesson, ui.session.step} != place) return;
    // What the program says stays until the student goes on.
    std::optional<int>& asked = ui.lesson.strip.card;
    if (!asked && !is_open_question(ui, lesson, *part)) asked = card;
}

/// Returns the page to which a bar leads, or -1.
int draw_lesson_text(Ui& ui, const Lesson& lesson, const PageFooter& pages, float width) {
    tick_off_tasks(ui, lesson);
    const LessonStep& step = step_on_show(ui, lesson);
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const Head head{plain_text(step.heading),
                    ui.session.step == 0
                        ? "lesson " + std::to_string(lesson_number(lesson.id))
                        : "step " + std::to_string(ui.session.step) + " of " + std::to_string(last),
                    pages};
    const int card = card_on_show(ui, lesson, step);
    const std::vector<Card> cards =
        is_drawer_open(ui) ? std::vector<Card>() : cards_of(ui, lesson, step);
    const int wanted = draw_head(ui, head, cards, card, width);
    draw_card(ui, lesson, step, card, width);
    return wanted;
}

int draw_stage(Ui& ui, const PageFooter& pages, float width) {
    const StageInfo& info = stage_info(ui.session.a.settings);
    const Head head{
        std::string(info.title),
        "stage " + std::to_string(pages.current + 1) + " of " + std::to_string(stage_count), pages};
    const int wanted = draw_head(ui, head, {}, text_card, width);
    const StageNote& note = ui.lesson.notes.find(note_name(ui.session));
    draw_sentences(ui, note.fault.empty() ? note.text : std::string(info.summary), width);
    return wanted;
}

/// The way to the whole text and back, below the buttons of the pages.
void draw_drawer_button(Ui& ui, float width) {
    const char* const label = is_drawer_open(ui) ? "▴ the whole text" : "▾ the whole text";
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(2.0f, 1.0f * ui.options.text_scale));
    const float own = button_width(label);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(width - own, 0.0f));
    if (button(ui, "lesson.whole", label, Look::link, tooltip_of("lesson.whole"), {own, 0.0f})) {
        find_action("lesson.whole").run(ui);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

} // namespace

float lesson_strip_height(const Ui& ui) {
    const float line = std::round(1.4f * ui.fonts.text->FontSize);
    const float u = ui.options.text_scale;
    const float two_lines = head_height * u + static_cast<float>(lines_of_strip) * line;
    return std::ceil(std::max(two_lines, ui.lesson.strip.height) + 2.0f * margin_y * u);
}

void draw_lesson_strip(Ui& ui, const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(14.0f * u, margin_y * u));
    ImGui::Begin("lesson strip", nullptr, panel_flags | ImGuiWindowFlags_NoScrollWithMouse);
    const float bottom = area.position.y + area.size.y - 0.5f;
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    ImGui::PushClipRect(area.position, end, false);
    ImGui::GetWindowDrawList()->AddLine({area.position.x, bottom}, {end.x, bottom}, packed(p.line));
    ImGui::PopClipRect();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float buttons = page_buttons_width(ui);
    const float text = std::max(room.x - buttons - middle_gap * u, 1.0f);

    const Lesson* const open = open_lesson_of(ui);
    const Lesson* const lesson = ui.session.page != SidePage::stage ? open : nullptr;
    const PageFooter pages = lesson != nullptr ? pages_of_lesson(ui, *lesson) : pages_of_stages(ui);

    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("lesson.strip.text", {text, room.y}, false, ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    const float width = std::max(text - ImGui::GetStyle().ScrollbarSize, 1.0f);
    ImGui::PushTextWrapPos(width);
    const int bar = lesson != nullptr ? draw_lesson_text(ui, *lesson, pages, width)
                                      : draw_stage(ui, pages, width);
    ImGui::PopTextWrapPos();
    ui.lesson.strip.height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    ImGui::EndChild();

    ImGui::SetCursorScreenPos({start.x + room.x - buttons, start.y});
    const int button = draw_page_buttons(ui, pages, button_height * u);
    ImGui::SetCursorScreenPos({start.x + room.x - buttons, start.y + (button_height + 5.0f) * u});
    draw_drawer_button(ui, buttons);
    ImGui::End();
    ImGui::PopStyleVar();
    const int wanted = std::max(bar, button);
    if (lesson != nullptr) {
        turn_to_step(ui, *lesson, wanted);
    } else {
        turn_to_stage(ui, wanted);
    }
}

} // namespace rasterwalk
