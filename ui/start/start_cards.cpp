#include "ui/start/start_cards.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "lessons/progress.h"
#include "session/content.h"
#include "ui/actions/view_files.h"
#include "ui/start/start_choice.h"
#include "ui/start/start_pictures.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The words on a card.
struct Card {
    StartChoice choice;
    const char* title;
    const char* about;
    std::array<const char*, 2> points; ///< left out where room is short
    const char* help;
};

constexpr std::array<Card, start_choice_count> cards{{
    {StartChoice::lessons,
     "Begin the lessons",
     "Read a little, predict, try.",
     {"The program checks every answer.", "Each step sets up its picture."},
     "Opens the lesson where you left off."},
    {StartChoice::stages,
     "Walk the stages",
     "Press play, stop anywhere, and look.",
     {"Time runs both ways, down to single edge samples.",
      "Click a pixel or a triangle to see where each number comes from."},
     "Begins at the first stage; the pictures above lead to each one."},
    {StartChoice::picture,
     "Check my own program",
     "What is wrong with it, where first, and why?",
     {"Your .cpp as it is, and again each time you save it; or a picture or rows it made.",
      "Each function is asked separately, so one mistake fails one line."},
     "Shows the files that can be checked."},
}};
static_assert(is_indexed_by(cards, &Card::choice));

/// In a browser, which has no compiler.
constexpr Card picture_card{
    StartChoice::picture,
    "Check my own picture",
    "What is wrong with it, where first, and why?",
    {"A picture your program saved, or the rows it printed.",
     "Rasterwalk tries the known mistakes to see which one explains yours."},
    "Shows the files that can be checked."};

/// The cards of this place.
std::array<Card, start_choice_count> cards_of(const Ui& ui) {
    std::array<Card, start_choice_count> shown = cards;
    if (ui.host.is_browser) shown[static_cast<std::size_t>(StartChoice::picture)] = picture_card;
    return shown;
}

/// What a card holds besides its pictures, with all its words and with fewer; design pixels. A
/// lower card has fewer words.
constexpr float height_without_pictures = 280.0f, brief_height_without_pictures = 245.0f;
constexpr float eloquent_card = 400.0f;

/// The most coming lessons that a card names.
constexpr std::size_t most_next_lessons = 5;

/// The lesson of the main button; null if there is none.
const Lesson* next_lesson(Ui& ui) {
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    const std::string& id = ui.lesson.scores.to_open();
    return id.empty() ? nullptr : ui.lesson.lessons.find(id);
}

/// Is the scene of the session the one that the program begins with?
bool is_room(const Ui& ui) {
    return ui.session.scene->path.ends_with(usual_scene);
}

/// The label of a button of this width.
std::string button_label(Ui& ui, StartChoice choice, float width) {
    if (choice == StartChoice::stages)
        return "Open " + std::string(is_room(ui) ? "the room" : "the scene");
    if (choice == StartChoice::picture) return "Choose a file …";
    const Lesson* const lesson = next_lesson(ui);
    if (lesson == nullptr) return "There are no lessons";
    const std::string title =
        fmt::format("Lesson {}: {}", lesson_number(lesson->id), lesson->title);
    const std::string label = fmt::format("{} · {} min", title, lesson->minutes);
    return button_width(label) <= width ? label : title;
}

/// How many lessons are done: a cell for each, with a gap between tracks, and in words for the
/// track of the lesson that comes next.
void draw_lesson_cells(Ui& ui, float width) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    if (lessons.empty()) return;
    const Course& course = ui.lesson.lessons.course();
    const auto track = [&](std::size_t i) { return place_in(course, lessons[i].id).track; };
    const Lesson* const next = next_lesson(ui);
    const std::size_t shown =
        next == nullptr ? course.tracks.size() : place_in(course, next->id).track;
    int done = 0, minutes = 0, done_of_track = 0;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float gap = 3.0f * u;
    const float between_tracks = 6.0f * u;
    const float gaps = gap * static_cast<float>(lessons.size() - 1) +
                       between_tracks * static_cast<float>(track(lessons.size() - 1) - track(0));
    const float cell = (width - gaps) / static_cast<float>(lessons.size());
    float x = low.x;
    ui.lesson.scores.renew(ui.lesson.progress, ui.lesson.lessons);
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const bool is_done = ui.lesson.scores.of(i).is_done;
        done += is_done ? 1 : 0;
        done_of_track += is_done && track(i) == shown ? 1 : 0;
        if (i > 0) x += between_tracks * static_cast<float>(track(i) - track(i - 1));
        minutes += lessons[i].minutes;
        const ImVec4& colour = is_done ? p.link : p.button_hovered;
        ImGui::GetWindowDrawList()->AddRectFilled({x, low.y}, {x + cell, low.y + 5.0f * u},
                                                  packed(colour), 2.0f * u);
        x += cell + gap;
    }
    ImGui::SetCursorScreenPos({low.x, low.y + 11.0f * u});
    std::string words =
        fmt::format("{} of {} lessons done · {} in all", done, lessons.size(), hours_text(minutes));
    if (shown < course.tracks.size()) {
        const TrackSize size = size_of_track(course, shown, lessons);
        const std::string of_track =
            fmt::format("{}: {} of {}, {} · ", course.tracks[shown].title, done_of_track,
                        size.lessons, hours_text(size.minutes));
        if (text_width(ui.fonts.small, of_track + words) <= width) words.insert(0, of_track);
    }
    text_in(p.dim, words, ui.fonts.small);
}

/// The lessons that come next, a line each, as many as fit.
void draw_next_lessons(Ui& ui, ImVec2 top, float width, float bottom) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    const Lesson* const next = next_lesson(ui);
    if (next == nullptr) return;
    const float line = ui.fonts.text->FontSize + 9.0f * u, indent = 28.0f * u;
    const auto room = static_cast<std::size_t>(std::max((bottom - top.y) / line, 0.0f));
    const std::size_t count = std::min({room, lessons.size(), most_next_lessons});
    // At the end of the course, earlier lessons fill the lines above.
    const auto first =
        std::min(static_cast<std::size_t>(next - lessons.data()), lessons.size() - count);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImFont* const font = ui.fonts.text;
    ImFont* const small = ui.fonts.small;
    float y = bottom - line * static_cast<float>(count);
    for (std::size_t i = first; i < first + count; ++i, y += line) {
        const Lesson& lesson = lessons[i];
        const bool is_done = ui.lesson.scores.of(i).is_done;
        const std::string mark = is_done ? "✓" : std::to_string(lesson_number(lesson.id));
        const std::string minutes = fmt::format("{} min", lesson.minutes);
        const float right = top.x + width - text_width(small, minutes);
        const bool is_next = &lesson == next;
        list->AddLine({top.x, std::round(y)}, {top.x + width, std::round(y)}, packed(p.line));
        const float text_y = std::round(y + 0.5f * (line - font->FontSize));
        list->AddText(font, font->FontSize, {top.x, text_y},
                      packed(is_done ? colour_of(Meaning::pass, ui.options.theme) : p.dim),
                      mark.c_str());
        list->AddText(font, font->FontSize, {top.x + indent, text_y},
                      packed(is_next ? p.text : p.dim),
                      shortened_to_words(lesson.title, right - top.x - indent - 8.0f * u).c_str());
        list->AddText(small, small->FontSize, {right, text_y + 2.0f * u}, packed(p.dim),
                      minutes.c_str());
    }
}

/// The button of a card: the chosen card's is the main one.
void draw_start_button(Ui& ui, const Card& card, ImVec2 size) {
    const bool is_chosen = ui.start.chosen == card.choice;
    const std::string label = shortened(button_label(ui, card.choice, size.x),
                                        size.x - 2.0f * ImGui::GetStyle().FramePadding.x);
    if (button(ui, start_button(card.choice), label, is_chosen ? Look::main : Look::plain,
               is_chosen ? std::string(card.help) + "\nKey: Enter" : std::string(card.help),
               size)) {
        take_start_choice(ui, card.choice);
        if (card.choice == StartChoice::picture) begin_choosing_result(ui);
    }
}

/// The ground of a card, with a line above the chosen one.
void draw_card_ground(const Ui& ui, ImVec2 low, ImVec2 high, bool is_chosen) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, packed(p.card), 5.0f * u);
    list->AddRectFilled(low, {high.x, low.y + 3.0f * u}, packed(is_chosen ? p.link : p.line));
}

/// A card next to the others. All have the same height.
void draw_tall_card(Ui& ui, const Card& card, ImVec2 low, ImVec2 size) {
    const float u = ui.options.text_scale;
    const float padding = 22.0f * u, control = 42.0f * u;
    draw_card_ground(ui, low, {low.x + size.x, low.y + size.y}, ui.start.chosen == card.choice);
    const float inner = size.x - 2.0f * padding;
    ImGui::SetCursorScreenPos({low.x + padding, low.y + padding});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + inner);
    wrapped_text(card.title, ui.fonts.title);
    wrapped_text(card.about);
    ImGui::Dummy({0.0f, 4.0f * u});
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    const bool is_brief = size.y < eloquent_card * u;
    for (const char* point : card.points) {
        wrapped_text(point);
        if (is_brief) break;
    }
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    const ImVec2 below{low.x + padding, ImGui::GetItemRectMax().y + 12.0f * u};
    const float bottom = low.y + size.y - padding;
    if (card.choice == StartChoice::lessons) {
        const float cells = bottom - control - 38.0f * u;
        draw_next_lessons(ui, below, inner, cells - 14.0f * u);
        ImGui::SetCursorScreenPos({low.x + padding, cells});
        draw_lesson_cells(ui, inner);
    } else {
        draw_start_pictures(
            ui, card.choice, below, {below.x + inner, bottom - control - 14.0f * u},
            size.y - (is_brief ? brief_height_without_pictures : height_without_pictures) * u);
    }
    ImGui::SetCursorScreenPos({low.x + padding, bottom - control});
    draw_start_button(ui, card, {inner, control});
}

/// Heights of a line in a small window, design pixels: the largest, and the least with a point.
constexpr float largest_low_card = 96.0f;
constexpr float roomy_low_card = 80.0f;

/// A card as a line of a small window: what it is, and its button at the right.
void draw_low_card(Ui& ui, const Card& card, ImVec2 low, ImVec2 size) {
    const float u = ui.options.text_scale;
    const bool is_roomy = size.y >= roomy_low_card * u;
    const float padding = (is_roomy ? 14.0f : 10.0f) * u;
    draw_card_ground(ui, low, {low.x + size.x, low.y + size.y}, ui.start.chosen == card.choice);
    const float wide = std::min(0.45f * size.x, 340.0f * u);
    ImGui::SetCursorScreenPos({low.x + padding, low.y + padding});
    ImGui::BeginGroup();
    put_text(card.title, ui.fonts.bold);
    ImGui::PushFont(ui.fonts.small);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x - wide - 3.0f * padding);
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    wrapped_text(card.about);
    if (is_roomy) wrapped_text(card.points.front());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::EndGroup();
    const float control = (is_roomy ? 42.0f : 34.0f) * u;
    ImGui::SetCursorScreenPos(
        {low.x + size.x - padding - wide, low.y + 0.5f * (size.y - control + 3.0f * u)});
    draw_start_button(ui, card, {wide, control});
}

} // namespace

void choose_focused_card(Ui& ui) {
    for (const Card& card : cards) {
        if (ui.focus.name == start_button(card.choice)) ui.start.chosen = card.choice;
    }
}

void draw_cards(Ui& ui, const StartLayout& page, float bottom) {
    const float u = ui.options.text_scale;
    const std::array<Card, start_choice_count> shown = cards_of(ui);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    if (page.is_small) {
        const float gap = 6.0f * u;
        const float height = std::clamp((bottom - start.y) / start_choice_count - gap, 52.0f * u,
                                        largest_low_card * u);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            draw_low_card(ui, shown[i], {start.x, start.y + static_cast<float>(i) * (height + gap)},
                          {page.width, height});
        }
        ImGui::SetCursorScreenPos({start.x, start.y + start_choice_count * (height + gap) - gap});
        ImGui::Dummy({page.width, 0.0f});
        return;
    }
    const float width = (page.width - page.gap * (start_choice_count - 1)) / start_choice_count;
    const float height = std::clamp(bottom - start.y, 300.0f * u, 440.0f * u);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        draw_tall_card(ui, shown[i],
                       {start.x + static_cast<float>(i) * (width + page.gap), start.y},
                       {width, height});
    }
    ImGui::SetCursorScreenPos({start.x, start.y + height});
    ImGui::Dummy({page.width, 0.0f});
}

} // namespace rasterwalk
