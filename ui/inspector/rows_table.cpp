#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "ui/inspector/rows_lines.h"
#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_row_headers(Ui& ui) {
    struct Header {
        const char* name;
        const char* help;
    };
    static constexpr const char* weight_word = "1/z"; // in a frame: weight_name()
    static constexpr Header who[] = {
        {"row", "Row of the picture. Row minus first row is the entry i of both arrays."},
        {"left", "Column of the row's left end: leftPixels[i].x"},
        {"right", "Column of the row's right end: rightPixels[i].x"},
        {"count", "Pixels from the left to the right end, both included."},
        {"left by", "Which sample wrote the left end: e1 [4] is edge 1, line[4]. ↻ counts how "
                    "often it was replaced."},
        {"right by", "Which sample wrote the right end: e1 [4] is edge 1, line[4]. ↻ counts how "
                     "often it was replaced."},
    };
    static constexpr Header values[] = {
        {"row", "Row of the picture. Row minus first row is the entry i of both arrays."},
        {"left", "Column of the row's left end: leftPixels[i].x"},
        {weight_word, "The weight used for interpolation, at the left end."},
        {"x", "The varying x at the left end. With perspective correction it is stored divided by "
              "z or w."},
        {"y", "The varying y at the left end. With perspective correction it is stored divided by "
              "z or w."},
        {"z", "The varying z at the left end. With perspective correction it is stored divided by "
              "z or w."},
        {"right", "Column of the row's right end: rightPixels[i].x"},
        {weight_word, "The weight used for interpolation, at the right end."},
        {"x", "The varying x at the right end. With perspective correction it is stored divided by "
              "z or w."},
        {"y", "The varying y at the right end. With perspective correction it is stored divided by "
              "z or w."},
        {"z", "The varying z at the right end. With perspective correction it is stored divided by "
              "z or w."},
    };
    const std::span<const Header> headers = ui.inspector.shows_end_values
                                                ? std::span<const Header>(values)
                                                : std::span<const Header>(who);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    int column = 0;
    for (int i = 0; column < ImGui::TableGetColumnCount(); ++i) {
        if (std::string_view(headers[i].name) == "count" && !has_counts()) continue;
        ImGui::TableSetColumnIndex(column++);
        const bool is_weight = std::string_view(headers[i].name) == weight_word;
        const std::string title(is_weight ? weight_name(ui.results.a.frame) : headers[i].name);
        right_aligned(title, palette(ui.options.theme).dim, ui.fonts.small);
        // The values of both ends have the same titles.
        const bool is_value = ui.inspector.shows_end_values && i >= 2 && i != 6;
        const std::string end = !is_value ? "" : i < 6 ? "left." : "right.";
        register_widget(ui, "rows.header." + end + headers[i].name, headers[i].help);
    }
}

/// Begins a table with the columns of the row table; false if none of it is to be drawn.
bool begin_row_table(Ui& ui, const char* name, ImGuiTableFlags flags, ImVec2 size) {
    const float u = ui.options.text_scale;
    const bool has_values = ui.inspector.shows_end_values;
    const ImVec2 padding = ImGui::GetStyle().CellPadding;
    const bool is_narrow = ui.inspector.is_narrow;
    const ImVec2 cell_padding{is_narrow ? 2.0f * u : padding.x, padding.y};
    static constexpr float roomy[] = {44, 78, 78, 46, 104, 104};
    constexpr float all_roomy = 44 + 78 + 78 + 46 + 104 + 104;
    const float width =
        size.x > 0.0f ? size.x : ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    const float writer_width = roomy[4] / all_roomy * width - 2.0f * cell_padding.x;
    const bool counts = !is_narrow && writer_width >= width_of_writer(ui);
    const int columns = has_values         ? 11
                        : !has_writers(ui) ? row_columns_without_writers
                        : counts           ? all_row_columns
                                           : all_row_columns - 1;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, cell_padding);
    const bool open = begin_lined_table(
        name, columns,
        flags | (has_values ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit
                            : ImGuiTableFlags_SizingStretchProp),
        size);
    ImGui::PopStyleVar();
    if (!open) return false;
    static constexpr float narrow[] = {28, 42, 42, 90, 90};
    const float* const widths = counts || !has_writers(ui) ? roomy : narrow;
    for (int i = 0; i < columns; ++i) {
        // The values of the left end are in sight without scrolling.
        const float value_width = i == 0 ? 40.0f : i == 1 || i == 6 ? 46.0f : 70.0f;
        ImGui::TableSetupColumn("", 0, has_values ? value_width * u : widths[i]);
    }
    return true;
}

/// @param height of what scrolls to the row at work or to a wanted one; none: nothing scrolls
void draw_all_rows(Ui& ui, std::optional<float> height) {
    const RowHistory& history = ui.results.a.rows;
    ImGui::PushFont(ui.fonts.mono);
    const auto is_above = [&](const OutsideSample& s) { return s.row < history.rows.first_row; };
    for (std::size_t i = 0; i < history.outside.size(); ++i) {
        if (is_above(history.outside[i]))
            draw_outside_line(ui, history.outside[i], static_cast<int>(i));
    }
    const auto above =
        static_cast<int>(std::count_if(history.outside.begin(), history.outside.end(), is_above));
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    ImGuiListClipper clipper;
    clipper.Begin(history.rows.size(), line);
    const std::optional<int> at_work = row_at_work(ui);
    const bool follows = ui.follow_cursor && height;
    if (follows && at_work && history.rows.size() > 0) {
        const int index = std::clamp(*at_work - history.rows.first_row, 0, history.rows.size() - 1);
        keep_items(clipper, index, index + 1);
    }
    const int wanted = height ? wanted_row(ui, *height) : -1;
    if (wanted < 0 || wanted >= history.rows.size()) {
        ui.inspector.scroll_to_row = false;
    } else {
        keep_items(clipper, wanted, wanted + 1);
    }
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_row_line(ui, i);
            const bool is_at_work = at_work == history.rows.first_row + i;
            if (follows && is_at_work && !ImGui::IsItemVisible()) scroll_to_line(above + i, line);
            if (i == wanted) bring_into_view(ui, above + i, line, i + 1 == history.rows.size());
        }
    }
    for (std::size_t i = 0; i < history.outside.size(); ++i) {
        if (!is_above(history.outside[i])) {
            draw_outside_line(ui, history.outside[i], static_cast<int>(i));
        }
    }
    ImGui::PopFont();
}

} // namespace

void draw_row_table(Ui& ui, float height) {
    // Whole lines, if it scrolls.
    const float padding = 2.0f * ImGui::GetStyle().CellPadding.y;
    const float around = ui.fonts.small->FontSize + padding +
                         (ui.inspector.shows_end_values ? ImGui::GetStyle().ScrollbarSize : 0.0f);
    const float line = ui.fonts.mono->FontSize + padding;
    const float lines = std::max(std::floor((height - around) / line), 1.0f);
    const RowHistory& history = ui.results.a.rows;
    const auto all = history.rows.size() + static_cast<int>(history.outside.size());
    if (lines < static_cast<float>(all)) height = around + lines * line;
    if (!begin_row_table(ui, "rows", ImGuiTableFlags_ScrollY, {0, height})) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    draw_row_headers(ui);
    draw_all_rows(ui, height);
    ImGui::EndTable();
}

void draw_row_table_in_page(Ui& ui) {
    if (!begin_row_table(ui, "rows", 0, {0, 0})) return;
    draw_row_headers(ui);
    draw_all_rows(ui, {});
    ImGui::EndTable();
}

void draw_row_table_with(Ui& ui, const std::function<void()>& below) {
    // The same width in both, whether or not the rows need a scroll bar.
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    if (begin_row_table(ui, "rows.head", 0, {width, 0})) {
        draw_row_headers(ui);
        ImGui::EndTable();
    }
    const float height = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("rows.body", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_line_clip();
    if (begin_row_table(ui, "rows", 0, {width, 0})) {
        draw_all_rows(ui, height);
        ImGui::EndTable();
    }
    ImGui::PushTextWrapPos(width);
    below();
    ImGui::PopTextWrapPos();
    end_line_clip();
    ImGui::EndChild();
}

} // namespace rasterwalk
