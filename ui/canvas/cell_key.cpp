#include "ui/canvas/cell_key.h"

#include <vector>

#include "base/element_names.h"
#include "base/numbers.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/cells.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Of more fragments than this on the picked pixel only the last are named.
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

} // namespace

bool shows_cell_key(const Ui& ui) {
    return wants_cell_key(ui) && (shows_numbers(ui) || shows_fates(ui));
}

std::string cell_key_text(const Ui& ui, bool is_short) {
    std::string text;
    const auto add = [&](const std::string& part) {
        if (!text.empty() && !part.empty()) text += "  ·  ";
        text += part;
    };
    if (shows_numbers(ui)) {
        const auto numbers = static_cast<std::size_t>(ui.session.canvas.numbers);
        const CellNumbersInfo& info = cell_numbers_list()[numbers];
        add("number: " + std::string(is_short ? info.title : info.key));
    }
    if (shows_fates(ui)) {
        add(picked_text(ui));
        const std::string signs[] = {passed_sign, failed_sign};
        if (const std::optional<int>& triangle = ui.results.a.triangle) {
            add(is_short
                    ? signs[0] + " " + signs[1] + " depth test of " + short_triangle_name(*triangle)
                    : signs[0] + " passed, " + signs[1] +
                          " failed the depth test: " + triangle_name(*triangle));
        }
    }
    return text;
}

void draw_cell_key(Ui& ui, const Pane& place) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(place.low, place.high, packed(p.card));
    list->AddLine(place.low, {place.high.x, place.low.y}, packed(p.line));
    const std::string text = cell_key_text(ui, false);
    ImGui::PushFont(ui.fonts.small);
    const float inset = 8.0f * u, room = place.room().x - 2.0f * inset;
    const bool fits = ImGui::CalcTextSize(text.c_str()).x <= room;
    const std::string shown = fits ? text : shortened(cell_key_text(ui, true), room);
    list->AddText({place.low.x + inset, std::round(place.low.y + 4.0f * u)}, packed(p.text),
                  shown.c_str());
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(place.low);
    ImGui::Dummy({std::max(place.room().x, 1.0f), std::max(place.room().y, 1.0f)});
    name_widget(ui, "canvas.cells",
                text + "\n\nThe signs in a cell are those of the triangle on show. In the picked "
                       "pixel there is one for each fragment, in the order of drawing; '…' stands "
                       "for earlier ones.");
    note_text(ui, "canvas.cells", text);
}

} // namespace rasterwalk
