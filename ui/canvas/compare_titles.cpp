#include "ui/canvas/compare_titles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ui/actions/compare.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What a title is wider than its words, and what it keeps free beside it, design pixels.
constexpr float title_border = 42.0f;
constexpr float title_gap = 4.0f, title_inset = 8.0f;

/// How wide the square with the letter is, screen pixels.
float letter_side(const Ui& ui) {
    return std::round(20.0f * ui.options.text_scale);
}

/// The words of a title: as many as leave the picture free, or else as have room. None if there is
/// no place even for the letter.
std::optional<std::string> title_words(const Ui& ui, bool of_b, const TitlePlace& title) {
    std::vector<std::string> forms = run_forms(ui.session, of_b);
    forms.emplace_back(); // the letter says which run it is
    const PicturePlace& place =
        of_b && ui.compare.place_of_b ? *ui.compare.place_of_b : ui.canvas.place;
    const float u = ui.options.text_scale;
    const float width =
        place.scale * static_cast<float>(ui.results.a.frame.settings.viewport.width);
    const bool lies_over = place.origin.y < title.top + title_height * u;
    const float beside =
        title.is_at_right ? title.right - place.origin.x - width : place.origin.x - title.left;
    const float room = title.right - title.left - title_border * u;
    const std::string words =
        lies_over ? first_fitting(forms, std::min(beside - title_border * u, room)) : "";
    if (!words.empty()) return words;
    if (!lies_over || title.may_lie_over) return first_fitting(forms, room);
    if (beside < letter_side(ui) + title_gap * u) return std::nullopt;
    return words;
}

} // namespace

TitlePlace place_of_title(const Ui& ui, const Pane& canvas, float left, float right, float top) {
    const float u = ui.options.text_scale, inset = title_inset * u;
    return {left + inset, right - inset, top, false, canvas.room().y >= low_canvas * u};
}

void draw_run_title(Ui& ui, ImDrawList* list, bool of_b, const TitlePlace& title) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImFont* const font = ui.fonts.small;
    const float side = letter_side(ui);
    ImGui::PushFont(font);
    const std::optional<std::string> words = title_words(ui, of_b, title);
    const float width = !words || words->empty() ? side : side + text_width(*words) + 16.0f * u;
    ImGui::PopFont();
    if (!words) return;
    const float x = title.is_at_right ? title.right - width : title.left;
    const ImVec2 low{std::round(x), std::round(title.top + 0.5f * (title_height * u - side))};
    ImVec4 ground = p.card;
    ground.w = 0.92f;
    list->AddRectFilled(low, {low.x + width, low.y + side}, packed(ground), 4.0f * u);
    list->AddRectFilled(low, {low.x + side, low.y + side}, packed(p.chosen), 4.0f * u);
    const char* const letter = of_b ? "B" : "A";
    ImFont* const bold = ui.fonts.bold;
    const float letter_size = font->FontSize;
    const float letter_width = text_width(bold, letter, letter_size);
    const float text_y = low.y + 0.5f * (side - letter_size);
    list->AddText(bold, letter_size, {low.x + 0.5f * (side - letter_width), text_y}, packed(p.text),
                  letter);
    list->AddText(font, font->FontSize, {low.x + side + 8.0f * u, text_y}, packed(p.text),
                  words->c_str());
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({width, side});
    name_widget(ui, of_b ? "compare.title_b" : "compare.title_a",
                (of_b ? "Run B: what it has otherwise than A.\n"
                      : "Run A: what it has otherwise than B. The switches and the settings "
                        "set this run.\n") +
                    run_assignments(ui.session, of_b));
    note_text(ui, of_b ? "compare.title_b" : "compare.title_a", *words);
}

void draw_both_titles(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const float middle = 0.5f * (canvas.low.x + canvas.high.x);
    draw_run_title(ui, list, false, place_of_title(ui, canvas, canvas.low.x, middle, canvas.low.y));
    TitlePlace right = place_of_title(ui, canvas, middle, canvas.high.x, canvas.low.y);
    right.is_at_right = true;
    draw_run_title(ui, list, true, right);
}

bool has_room_for_letter(const Ui& ui, ImVec2 room, float zoom) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float u = ui.options.text_scale;
    const float beside = 0.5f * (room.x - zoom * static_cast<float>(size.width));
    const float above = 0.5f * (room.y - zoom * static_cast<float>(size.height));
    return beside >= letter_side(ui) + (title_inset + title_gap) * u || above >= title_height * u;
}

} // namespace rasterwalk
