#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "ui/inspector/mine_parts.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The rows shown of a long table: so many before the first that differs, and after it.
constexpr std::size_t rows_before = 2, rows_after = 5;

/// The ends of a row, columns; none: the table has no such row.
struct TableEnds {
    std::optional<double> left, right;

    friend bool operator==(const TableEnds&, const TableEnds&) = default;
};

/// A row of a table, by its place in leftPixels and rightPixels: what a program says about the
/// number of a row may be anything.
TableEnds ends_at(const RowLists& lists, std::size_t index) {
    TableEnds ends;
    if (index < lists.left.pixels.size()) ends.left = lists.left.pixels[index].x;
    if (index < lists.right.pixels.size()) ends.right = lists.right.pixels[index].x;
    return ends;
}

std::string end_text(const std::optional<double>& column) {
    return column ? fmt::format("{:.6g}", *column) : "–";
}

void draw_header(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.fonts.small);
    const auto head = [&](const char* words, const ImVec4& ink) {
        ImGui::TableNextColumn();
        right_aligned(words, ink);
    };
    const ImVec4 left = colour_of(Meaning::left_end, ui.options.theme);
    const ImVec4 right = colour_of(Meaning::right_end, ui.options.theme);
    head("row", p.dim);
    head("left: mine", left);
    head("ours", left);
    head("right: mine", right);
    head("ours", right);
    ImGui::PopFont();
}

/// @param index in the tables, from 0
/// @param number of the row of the picture
void draw_row(Ui& ui, std::size_t index, double number, const TableEnds& mine,
              const TableEnds& ours) {
    const Palette& p = palette(ui.options.theme);
    const ImVec4 wrong = colour_of(Meaning::fail, ui.options.theme);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const bool is_same = mine == ours;
    right_aligned((is_same ? "" : std::string(failed_sign) + " ") + fmt::format("{:.6g}", number),
                  is_same ? p.dim : wrong, ui.fonts.mono);
    register_widget(ui, fmt::format("mine.row.{}", index),
                    is_same ? "Both tables have the same ends here." : "The ends differ here.",
                    end_text(mine.left) + " " + end_text(mine.right));
    const auto pair = [&](const std::optional<double>& a, const std::optional<double>& b) {
        ImGui::TableNextColumn();
        right_aligned(end_text(a), a == b ? p.text : wrong, ui.fonts.mono);
        ImGui::TableNextColumn();
        right_aligned(end_text(b), p.dim, ui.fonts.mono);
    };
    pair(mine.left, ours.left);
    pair(mine.right, ours.right);
}

} // namespace

void draw_both_row_tables(Ui& ui, const FunctionCheck& check) {
    const RowLists &mine = check.difference.their_rows, &ours = check.difference.our_rows;
    // Without ours, the rows have the right ends, and something that they carry is wrong.
    if (check.part != rasterwalk_kit::part_polygon_rows || ours.left.pixels.empty()) return;
    const std::size_t count =
        std::max({mine.left.pixels.size(), mine.right.pixels.size(), ours.left.pixels.size()});
    std::size_t first = 0;
    while (first < count && ends_at(mine, first) == ends_at(ours, first))
        ++first;
    if (first == count) return;
    text_in(palette(ui.options.theme).text, "Both row tables", ui.fonts.bold);
    register_widget(ui, "mine.rows",
                    "The row table that your function made of our polygon, and ours, around the "
                    "first row that differs.");
    if (!begin_lined_table("mine.rows", 5, ImGuiTableFlags_SizingStretchSame,
                           {ImGui::CalcItemWidth(), 0.0f}))
        return;
    draw_header(ui);
    const std::size_t begin = first - std::min(first, rows_before);
    for (std::size_t i = begin; i < std::min(count, first + rows_after + 1); ++i)
        draw_row(ui, i, ours.left.pixels.front().y + static_cast<double>(i), ends_at(mine, i),
                 ends_at(ours, i));
    ImGui::EndTable();
    ImGui::Spacing();
}

} // namespace rasterwalk
