#include "ui/canvas/cell_key.h"

#include <vector>

#include "base/element_names.h"
#include "base/numbers.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/marks.h"
#include "ui/canvas/test_marks.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// If the picked pixel has more fragments than this, only the last are named.
constexpr std::ptrdiff_t most_fragments = 6;

bool shows_numbers(const Ui& ui) {
    const CellNumbers numbers = ui.session.canvas.numbers;
    return numbers != CellNumbers::none && ui.canvas.place.scale >= numbers_zoom(ui, numbers);
}

/// "(240, 300): t3 ✓, t9 ✗", as far as it is drawn; empty without a picked pixel.
std::string picked_text(const Ui& ui) {
    const std::optional<PixelHistory>& history = ui.results.history;
    if (!history) return {};
    std::vector<std::string> names;
    for (const PixelEntry& entry : history->entries) {
        if (!(entry.cursor < ui.results.a.cursor)) break;
        names.push_back(short_triangle_name(entry.cursor.triangle) + " " +
                        (entry.fate == Fate::written ? passed_sign : failed_sign));
    }
    if (names.empty()) return {};
    const auto count = std::ssize(names);
    std::string text = "(" + std::to_string(history->pixel.x) + ", " +
                       std::to_string(history->pixel.y) + ")" + ": ";
    if (count > most_fragments) text += "… ";
    for (auto i = std::max(count - most_fragments, std::ptrdiff_t{0}); i < count; ++i) {
        text += names[static_cast<std::size_t>(i)];
        if (i + 1 < count) text += ", ";
    }
    return text;
}

/// The colours of tested pixels, each before its word.
/// @return where the next words can begin, screen pixels
float draw_test_colours(const Ui& ui, ImDrawList* list, ImVec2 at) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float side = std::round(0.75f * ui.fonts.small->FontSize);
    float x = at.x;
    struct Answer {
        Meaning meaning;
        const char* word;
    };
    for (const Answer& answer : {Answer{Meaning::pass, "inside"}, {Meaning::fail, "outside"}}) {
        const ImVec2 low{x, at.y + 0.5f * (ui.fonts.small->FontSize - side)};
        const ImVec2 high{low.x + side, low.y + side};
        // As on the picture, which is dark in both themes.
        list->AddRectFilled(low, high, dark_casing);
        list->AddRectFilled(low, high, packed(colour_of(answer.meaning, Theme::dark), 0.4f));
        list->AddRect(low, high, packed(colour_of(answer.meaning, Theme::dark)));
        x += side + 5.0f * u;
        list->AddText({x, at.y}, packed(p.text), answer.word);
        x += text_width(answer.word) + 12.0f * u;
    }
    return x;
}

/// What the colours say, for readers who cannot see them.
constexpr const char* test_colours_text =
    "Tested pixels: blue inside, orange outside. The frame is the box that is tested; the band "
    "along each edge is on its inner side.";

} // namespace

bool shows_cell_key(const Ui& ui) {
    return wants_cell_key(ui) && (shows_numbers(ui) || shows_fates(ui) || shows_tests(ui));
}

std::vector<std::string> cell_key_forms(const Ui& ui) {
    std::vector<std::string> forms(4);
    const auto add = [&](const std::string(&parts)[4]) {
        for (std::size_t i = 0; i < forms.size(); ++i) {
            if (!forms[i].empty() && !parts[i].empty()) forms[i] += "  ·  ";
            forms[i] += parts[i];
        }
    };
    if (shows_numbers(ui) && (!is_of_tests(ui.session.canvas.numbers) || shows_tests(ui))) {
        const CellNumbersWords words =
            cell_numbers_words(ui.session.canvas.numbers, depth_words(ui.results.a.frame));
        const std::string& title = words.title;
        add({"number: " + words.key, "number: " + title, "number: " + title, title});
    }
    if (shows_fates(ui)) {
        const std::string picked = picked_text(ui);
        add({picked, picked, picked, ""});
        if (const std::optional<int>& triangle = ui.results.a.triangle) {
            const std::string passed = passed_sign, failed = failed_sign;
            const std::string name = short_triangle_name(*triangle);
            const std::string signs = passed + " " + failed + " ";
            add({passed + " passed, " + failed +
                     " failed the depth test: " + triangle_name(*triangle),
                 signs + "depth test of " + name, signs + name, signs + name});
        }
    }
    return forms;
}

void draw_cell_key(Ui& ui, const Pane& place) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(place.low, place.high, packed(p.card));
    list->AddLine(place.low, {place.high.x, place.low.y}, packed(p.line));
    const std::vector<std::string> forms = cell_key_forms(ui);
    const std::string& text = forms.front();
    ImGui::PushFont(ui.fonts.small);
    const float inset = 8.0f * u;
    ImVec2 at{place.low.x + inset, std::round(place.low.y + 4.0f * u)};
    list->PushClipRect(place.low, place.high, true);
    const bool has_tests = shows_tests(ui);
    if (has_tests) at.x = draw_test_colours(ui, list, at);
    list->AddText(at, packed(p.text), first_fitting(forms, place.high.x - inset - at.x).c_str());
    list->PopClipRect();
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(place.low);
    ImGui::Dummy({std::max(place.room().x, 1.0f), std::max(place.room().y, 1.0f)});
    register_widget(
        ui, "canvas.cells",
        (has_tests ? std::string(test_colours_text) + "\n\n" : std::string()) + text +
            "\n\nThe signs in a cell belong to the triangle shown. The picked pixel has "
            "one sign for each fragment, in drawing order; '…' stands for earlier ones.",
        text);
}

} // namespace rasterwalk
