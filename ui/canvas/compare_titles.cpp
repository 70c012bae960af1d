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

/// How much wider a title is than its words, and what it keeps free next to it, design pixels.
constexpr float title_border = 42.0f;
constexpr float title_gap = 4.0f, title_inset = 8.0f;

/// How wide the square with the letter is, screen pixels.
float letter_side(const Ui& ui) {
    return std::round(20.0f * ui.options.text_scale);
}

/// Space between the picture and the border that the title is at, screen pixels.
float side_room(const Ui& ui, bool of_b, const TitlePlace& title) {
    const PicturePlace& place =
        of_b && ui.compare.place_of_b ? *ui.compare.place_of_b : ui.canvas.place;
    const float width =
        place.scale * static_cast<float>(ui.results.a.frame.settings.viewport.width);
    return title.is_at_right ? title.right - place.origin.x - width : place.origin.x - title.left;
}

/// Does the picture reach up to the title?
bool lies_over(const Ui& ui, bool of_b, const TitlePlace& title) {
    const PicturePlace& place =
        of_b && ui.compare.place_of_b ? *ui.compare.place_of_b : ui.canvas.place;
    return place.origin.y < title.top + title_height * ui.options.text_scale;
}

/// What can be said about a run, from the longest form to the shortest, which is the letter alone.
std::vector<std::string> title_forms(const Ui& ui, bool of_b) {
    std::vector<std::string> forms = run_forms(ui.session, of_b);
    forms.emplace_back();
    return forms;
}

/// Which of the forms fits a title: the first that leaves the picture free, or else the first that
/// has room. None if there is no place even for the letter.
std::optional<std::size_t> fitting_form(const Ui& ui, bool of_b, const TitlePlace& title) {
    const std::vector<std::string> forms = title_forms(ui, of_b);
    const float u = ui.options.text_scale;
    const bool is_over = lies_over(ui, of_b, title);
    const float beside = side_room(ui, of_b, title);
    const float room = title.right - title.left - title_border * u;
    const auto first_within = [&](float width) {
        const auto found = std::find_if(forms.begin(), forms.end(), [&](const std::string& form) {
            return form.empty() || text_width(form) <= width;
        });
        return static_cast<std::size_t>(found - forms.begin());
    };
    const std::size_t last = forms.size() - 1;
    const std::size_t free =
        is_over ? first_within(std::min(beside - title_border * u, room)) : last;
    if (free < last) return free;
    if (!is_over || title.may_lie_over) return first_within(room);
    if (beside < letter_side(ui) + title_gap * u) return std::nullopt;
    return last;
}

/// A title in one of its forms.
void draw_title(Ui& ui, ImDrawList* list, bool of_b, const TitlePlace& title, std::size_t form) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImFont* const font = ui.fonts.small;
    const float side = letter_side(ui);
    const std::string words = title_forms(ui, of_b)[form];
    const float width = words.empty() ? side : side + text_width(font, words) + 16.0f * u;
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
                  words.c_str());
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({width, side});
    register_widget(ui, of_b ? "compare.title_b" : "compare.title_a",
                    (of_b
                         ? "Run B: where it differs from A.\n"
                         : "Run A: where it differs from B. The switches and the settings apply to "
                           "this run.\n") +
                        run_assignments(ui.session, of_b),
                    words);
}

} // namespace

TitlePlace place_of_title(const Ui& ui, const Pane& canvas, float left, float right, float top) {
    const float u = ui.options.text_scale, inset = title_inset * u;
    return {left + inset, right - inset, top, false, canvas.room().y >= low_canvas * u};
}

void draw_run_title(Ui& ui, ImDrawList* list, bool of_b, const TitlePlace& title) {
    ImGui::PushFont(ui.fonts.small);
    const std::optional<std::size_t> form = fitting_form(ui, of_b, title);
    ImGui::PopFont();
    if (form) draw_title(ui, list, of_b, title, *form);
}

void draw_two_titles(Ui& ui, ImDrawList* list, const TitlePlace& a, const TitlePlace& b) {
    ImGui::PushFont(ui.fonts.small);
    const std::optional<std::size_t> form_a = fitting_form(ui, false, a);
    const std::optional<std::size_t> form_b = fitting_form(ui, true, b);
    ImGui::PopFont();
    const std::size_t letter_of_a = title_forms(ui, false).size() - 1;
    const std::size_t letter_of_b = title_forms(ui, true).size() - 1;
    // What one has no room for is not said about the other either: it would look like a difference.
    const std::size_t form = std::max(form_a.value_or(letter_of_a), form_b.value_or(letter_of_b));
    const bool is_letter = form >= std::min(letter_of_a, letter_of_b);
    if (form_a) draw_title(ui, list, false, a, is_letter ? letter_of_a : form);
    if (form_b) draw_title(ui, list, true, b, is_letter ? letter_of_b : form);
}

void draw_both_titles(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const float middle = 0.5f * (canvas.low.x + canvas.high.x);
    TitlePlace right = place_of_title(ui, canvas, middle, canvas.high.x, canvas.low.y);
    right.is_at_right = true;
    draw_two_titles(ui, list, place_of_title(ui, canvas, canvas.low.x, middle, canvas.low.y),
                    right);
}

bool has_room_for_letter(const Ui& ui, ImVec2 room, float zoom) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float u = ui.options.text_scale;
    const float beside = 0.5f * (room.x - zoom * static_cast<float>(size.width));
    const float above = 0.5f * (room.y - zoom * static_cast<float>(size.height));
    return beside >= letter_side(ui) + (title_inset + title_gap) * u || above >= title_height * u;
}

} // namespace rasterwalk
