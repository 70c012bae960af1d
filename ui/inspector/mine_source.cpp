#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/quoted.h"
#include "ui/inspector/mine_parts.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr int lines_around = 3, lines_of_function = 12;

/// Reads the lines, unless they are those of the same place in the same check.
const SourceLines& lines_of(Ui& ui, const ProgramPlace& place, PlaceKind kind) {
    MineSource& source = ui.mine.source;
    if (source.of != ui.mine.number || !(source.place == place)) {
        source.shown = kind == PlaceKind::definition
                           ? source_lines(place, 0, lines_of_function)
                           : source_lines(place, lines_around, lines_around);
        source.place = place;
        source.of = ui.mine.number;
    }
    return source.shown;
}

} // namespace

std::string place_text(const CheckedProgram& checked, const ProgramPlace& place) {
    if (place.line == 0) return {};
    return fmt::format("{}:{}", visible_line(shown_path(checked.files, place.file)), place.line);
}

void draw_source(Ui& ui, const CheckedProgram& checked, const ProgramPlace& place, PlaceKind kind) {
    const SourceLines& source = lines_of(ui, place, kind);
    if (source.lines.empty()) return;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const std::string title = place_text(checked, place);
    text_in(p.dim, title, ui.fonts.mono_small);
    register_widget(ui, "mine.place", place.file, title);
    ImGui::PushFont(ui.fonts.mono_small);
    const float height = ImGui::GetTextLineHeight() + 4.0f * u;
    const int last = source.first + static_cast<int>(source.lines.size()) - 1;
    const float digits = text_width(std::to_string(last));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
        const int number = source.first + static_cast<int>(i);
        const bool is_meant = number == place.line && kind == PlaceKind::fault;
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float right = low.x + ImGui::GetContentRegionAvail().x;
        const float bottom = low.y + height, top = low.y + 2.0f * u;
        if (is_meant) {
            list->AddRectFilled(low, {right, bottom}, packed(p.row_lit));
            list->AddRectFilled(low, {low.x + 3.0f * u, bottom},
                                packed(colour_of(Meaning::fail, ui.options.theme)));
        }
        const std::string digit_text = std::to_string(number);
        list->AddText({low.x + 8.0f * u + digits - text_width(digit_text), top}, packed(p.dim),
                      digit_text.c_str());
        const float left = low.x + 20.0f * u + digits;
        list->AddText({left, top}, packed(is_meant ? p.text : p.dim),
                      shortened(source.lines[i], right - left).c_str());
        ImGui::Dummy({std::max(right - low.x, 1.0f), height - ImGui::GetStyle().ItemSpacing.y});
        register_widget(ui, fmt::format("mine.source.{}", number), source.lines[i],
                        source.lines[i]);
    }
    ImGui::PopFont();
    ImGui::Spacing();
}

} // namespace rasterwalk
