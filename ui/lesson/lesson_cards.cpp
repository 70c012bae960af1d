#include "ui/lesson/lesson_cards.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "text/markdown_text.h"
#include "ui/actions/open_lesson.h"
#include "ui/lesson/fitting_sentences.h"
#include "ui/lesson/lesson_end.h"
#include "ui/lesson/lesson_predictions.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Space between two words, design pixels.
constexpr float word_gap = 14.0f;

/// A part of the step as a word.
struct PartWord {
    int part = 0;
    std::string name;  ///< of the widget
    std::string title; ///< with a sign if it is done
    const char* help = "";
};

/// The long text of a part: its own, or the reason for an answer that is shown.
std::string words_to_cut(Ui& ui, const Lesson& lesson, const LessonPart& part) {
    if (part.kind == LessonPart::Kind::text) return with_footnotes(lesson, part.text);
    if (part.kind != LessonPart::Kind::prediction) return {};
    const LessonPrediction& prediction = lesson.predictions[static_cast<std::size_t>(part.index)];
    take_up_answer(ui, lesson, prediction);
    if (!is_revealed(ui, lesson, prediction)) return {};
    return shown_reason(ui.lesson.predictions[prediction.id]);
}

/// A card for each piece of a text or a reason, and one for anything else in the step.
std::vector<LessonCard> cut(Ui& ui, const Lesson& lesson, const LessonStep& step, float width,
                            float height) {
    std::vector<LessonCard> cards;
    const auto add = [&](std::size_t part, const std::string& words) {
        for (MarkdownDocument& page :
             fitting_parts(ui, parse_markdown(words), width, lines_of_strip(ui), height))
            cards.push_back({static_cast<int>(part), std::move(page)});
    };
    for (std::size_t i = 0; i < step.parts.size(); ++i) {
        const LessonPart& part = step.parts[i];
        if (part.kind == LessonPart::Kind::control) continue; // it is on its neighbours' cards
        const std::string words = words_to_cut(ui, lesson, part);
        if (words.empty()) cards.push_back({static_cast<int>(i), {}});
        add(i, words);
    }
    if (is_last_step(ui, lesson)) add(step.parts.size(), end_of_lesson(ui, lesson));
    if (cards.empty()) cards.push_back({0, parse_markdown(lesson.about)});
    return cards;
}

/// Does the part have a card?
bool has_card(const LessonStrip& strip, int part) {
    return std::any_of(strip.cards.begin(), strip.cards.end(),
                       [&](const LessonCard& card) { return card.part == part; });
}

std::string sign_of(Ui& ui, const Lesson& lesson, const LessonPart& part) {
    const auto index = static_cast<std::size_t>(part.index);
    const auto sign_of_task = [&](const std::string& id) {
        return ui.lesson.progress.is_task_done(lesson.id, id) ? "✓ " : "";
    };
    if (part.kind == LessonPart::Kind::task) return sign_of_task(lesson.tasks[index].id);
    if (part.kind == LessonPart::Kind::puzzle) return sign_of_task(lesson.puzzles[index].id);
    take_up_answer(ui, lesson, lesson.predictions[index]);
    const PredictionView& view = ui.lesson.predictions[lesson.predictions[index].id];
    if (!is_revealed(ui, lesson, lesson.predictions[index])) return "";
    return view.said.empty() ? "" : view.judged->is_right ? "✓ " : "✗ ";
}

/// The length of the text on a part's cards before this one.
std::size_t length_before(const LessonStrip& strip, int part, std::size_t end) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < end; ++i)
        length += strip.cards[i].part == part ? plain_text(strip.cards[i].page.blocks).size() : 0;
    return length;
}

/// Where in the step a card begins.
LessonPlace beginning_of(const LessonStrip& strip, int index) {
    const auto card = static_cast<std::size_t>(index);
    const int part = strip.cards[card].part;
    const std::size_t whole = length_before(strip, part, strip.cards.size());
    const auto before = static_cast<float>(length_before(strip, part, card));
    return {part, whole > 0 ? before / static_cast<float>(whole) : 0.0f};
}

/// The card that contains a place of the step.
int card_at(const LessonStrip& strip, const LessonPlace& place) {
    // Cards of different widths have their blanks in different places.
    constexpr float blanks = 0.01f;
    int card = card_of_part(strip, place.part);
    for (int i = card + 1; i < static_cast<int>(strip.cards.size()); ++i) {
        const LessonPlace beginning = beginning_of(strip, i);
        if (beginning.part == place.part && beginning.share <= place.share + blanks) card = i;
    }
    return card;
}

/// Which of its part's cards is shown: " 2/3"; empty if the part is one card.
std::string place_of_card(const LessonStrip& strip, int part) {
    const auto is_of_part = [&](const LessonCard& card) { return card.part == part; };
    const auto count = std::count_if(strip.cards.begin(), strip.cards.end(), is_of_part);
    const int place = strip.card - card_of_part(strip, part) + 1;
    return count > 1 ? " " + std::to_string(place) + "/" + std::to_string(count) : std::string();
}

std::vector<PartWord> words_of(Ui& ui, const Lesson& lesson, const LessonStep& step, int shown) {
    using Kind = LessonPart::Kind;
    const LessonStrip& strip = ui.lesson.strip;
    const auto count_of = [&](Kind kind) {
        return std::count_if(step.parts.begin(), step.parts.end(),
                             [&](const LessonPart& part) { return part.kind == kind; });
    };
    std::vector<PartWord> words;
    int texts = 0, questions = 0, tasks = 0;
    for (std::size_t i = 0; i < step.parts.size(); ++i) {
        const LessonPart& part = step.parts[i];
        const int index = static_cast<int>(i);
        if (part.kind == Kind::control) continue;
        if (!strip.cards.empty() && !has_card(strip, index)) continue;
        PartWord word{index, "lesson.card." + std::to_string(i), {}, ""};
        if (part.kind == Kind::text) {
            ++texts;
            word.title = tr(texts == 1 ? "text" : "more");
            word.help = tr(texts == 1 ? "Shows the first part of this step."
                                      : "Shows the next part of this step.");
            if (texts == 1) word.name = "lesson.card.text";
            if (index == shown) word.title += place_of_card(strip, index);
        } else if (part.kind == Kind::puzzle) {
            word.title = sign_of(ui, lesson, part) + tr("code");
            word.help = tr("Shows the lines to put in order.");
        } else {
            const bool is_task = part.kind == Kind::task;
            int& number = is_task ? tasks : questions;
            ++number;
            word.title = sign_of(ui, lesson, part) + tr(is_task ? "task" : "question");
            if (count_of(part.kind) > 1) word.title += " " + std::to_string(number);
            word.help = tr(is_task ? "Shows the task."
                                   : "Answer first; then the program shows its own answer.");
        }
        words.push_back(word);
    }
    const int end = static_cast<int>(step.parts.size());
    if (is_last_step(ui, lesson) && (strip.cards.empty() || has_card(strip, end))) {
        words.push_back({end, "lesson.card.end", tr("end"),
                         tr("What you have done, and where to go from here.")});
    }
    // If there is one part in one piece, that is all there is to see.
    if (words.size() == 1 && strip.cards.size() <= 1) words.clear();
    return words;
}

} // namespace

void cut_cards(Ui& ui, const Lesson& lesson, const LessonStep& step, float width, float height) {
    LessonStrip& strip = ui.lesson.strip;
    const float text_size = ui.fonts.text->FontSize;
    const bool is_known = strip.cards_width == width && strip.cards_text_size == text_size &&
                          strip.cards_height == height && !strip.is_recut &&
                          strip.cards_of == ui.lesson.lessons.number();
    strip.is_recut = false;
    strip.cards_of = ui.lesson.lessons.number();
    if (strip.cards.empty() || !is_known) {
        if (!strip.cards.empty() && !strip.read_to) strip.read_to = beginning_of(strip, strip.card);
        strip.cards = cut(ui, lesson, step, width, height);
        strip.cards_width = width;
        strip.cards_height = height;
        strip.cards_text_size = text_size;
    }
    const int last = static_cast<int>(strip.cards.size()) - 1;
    if (strip.read_to) strip.card = card_at(strip, *strip.read_to);
    if (ui.lesson.wants_end) strip.card = last;
    strip.read_to.reset();
    ui.lesson.wants_end = false;
    strip.card = std::clamp(strip.card, 0, last);
    strip.place = beginning_of(strip, strip.card);
}

int card_of_part(const LessonStrip& strip, int part) {
    const auto found = std::find_if(strip.cards.begin(), strip.cards.end(),
                                    [&](const LessonCard& card) { return card.part >= part; });
    return found == strip.cards.end() ? 0 : static_cast<int>(found - strip.cards.begin());
}

float part_words_width(Ui& ui, const Lesson& lesson, const LessonStep& step, int shown) {
    float width = 0.0f;
    ImGui::PushFont(ui.fonts.small);
    for (const PartWord& word : words_of(ui, lesson, step, shown))
        width += text_width(word.title) + word_gap * ui.options.text_scale;
    ImGui::PopFont();
    return width;
}

int draw_part_words(Ui& ui, const Lesson& lesson, const LessonStep& step, int shown,
                    const Area& area) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImVec2 at = area.position;
    const float end = at.x + area.size.x, height = area.size.y;
    int pressed = -1;
    ImGui::PushFont(ui.fonts.small);
    for (const PartWord& word : words_of(ui, lesson, step, shown)) {
        const float width = std::max(text_width(word.title), 1.0f);
        if (at.x + width > end) break;
        ImGui::SetCursorScreenPos(at);
        if (ImGui::InvisibleButton(word.name.c_str(), {width, height})) pressed = word.part;
        const bool hovered = ImGui::IsItemHovered();
        register_widget(ui, word.name, word.help);
        const bool is_shown = word.part == shown;
        ImDrawList* const list = ImGui::GetWindowDrawList();
        list->AddText({at.x, at.y + 0.5f * (height - ImGui::GetFontSize())},
                      packed(is_shown || hovered ? p.text : p.link), word.title.c_str());
        if (is_shown) {
            const float bottom = at.y + height - 1.0f * u;
            list->AddRectFilled({at.x, bottom - 2.0f * u}, {at.x + width, bottom}, packed(p.link));
        }
        at.x += width + word_gap * u;
    }
    ImGui::PopFont();
    return pressed;
}

} // namespace rasterwalk
