#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// One end of a row: its column, in the colour of who wrote it; in a box if that was just now.
void draw_end_cell(Ui& ui, const std::string& name, const RowEnd& end, const EndWriter& writer,
                   bool is_left, bool is_changed) {
    const ImVec4 colour = writer.is_set() ? colour_of(edge_meaning(writer.edge), ui.options.theme)
                                          : palette(ui.options.theme).dim;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    std::string text = end_text(end, is_left);
    if (ImGui::CalcTextSize(text.c_str()).x > width) text = end_text(end, is_left, true);
    right_aligned(text, colour);
    if (is_changed) {
        draw_changed_box(ui, ImGui::GetWindowDrawList(), low,
                         {low.x + width, low.y + ImGui::GetTextLineHeight()});
    }
    name_widget(ui, name, end_tooltip(ui, end, writer));
    if (writer.is_set() && ImGui::IsItemClicked()) go_to_sample(ui, writer.edge, writer.sample);
}

/// Before the sign that tells how often an end was replaced, design pixels.
constexpr float sign_gap = 4.0f;

float width_of_sign(const Ui& ui) {
    return text_width(ui.fonts.small, "↻0");
}

/// The width of the longest name of a sample of the triangle on show.
float widest_writer(const Ui& ui) {
    const std::vector<int>& counts = ui.results.a.rows.edge_samples;
    const auto most = std::max_element(counts.begin(), counts.end());
    const int last = most != counts.end() ? std::max(*most - 1, 0) : 0;
    return text_width(ui.fonts.mono, sample_text(0, last));
}

void draw_writer_cell(Ui& ui, const std::string& name, const EndWriter& writer) {
    const Palette& p = palette(ui.options.theme);
    if (!writer.is_set()) {
        right_aligned("—", p.dim);
        return;
    }
    // How often it was replaced stands apart, small and behind who wrote it; where there is no room
    // for it, the tooltip says it.
    const float gap = sign_gap * ui.options.text_scale;
    const float sign_width = gap + width_of_sign(ui);
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string whole = sample_text(writer.edge, writer.sample);
    const std::string plain = fmt::format("e{} {}", writer.edge, writer.sample);
    const std::string text = first_fitting({whole, plain}, room);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const bool has_sign = room >= widest_writer(ui) + sign_width;
    const float before = room - width - (has_sign ? sign_width : 0.0f);
    if (before > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + before);
    text_in(colour_of(edge_meaning(writer.edge), ui.options.theme), text);
    name_widget(ui, name, writer_tooltip(writer));
    if (ImGui::IsItemClicked()) go_to_sample(ui, writer.edge, writer.sample);
    if (!has_sign || writer.replaced == 0 || writer.replaced > 9) return;
    ImGui::SameLine(0.0f, gap);
    ImGui::PushFont(ui.fonts.small);
    text_in(p.dim, "↻" + std::to_string(writer.replaced));
    ImGui::PopFont();
    name_widget(ui, name + ".replaced", replaced_tooltip(writer));
}

/// The varying that the stage uses; where it uses none, the first: the place in the room.
const VaryingInfo& shown_varying(const Frame& frame) {
    const VaryingSet read = frame.stages.varyings_read(shading_rule(frame.settings));
    for (int i = 0; i < varying_count; ++i) {
        if (read.has(i)) return varying_list[static_cast<std::size_t>(i)];
    }
    return varying_list.front();
}

void draw_values(Ui& ui, const RowEnd& end, bool is_set) {
    const Palette& p = palette(ui.options.theme);
    const VaryingInfo& varying = shown_varying(ui.results.a.frame);
    const auto draw = [&](bool has_number, float number) {
        ImGui::TableNextColumn();
        right_aligned(has_number ? fixed(static_cast<double>(number), 4) : "—",
                      has_number ? p.text : p.dim);
    };
    draw(is_set, end.inv_w);
    for (int i = 0; i < 3; ++i) {
        const bool has_number = is_set && i < varying.count;
        draw(has_number, has_number ? varying.component(end.varyings, i) : 0.0f);
    }
}

/// Columns of the table without the values of the ends: all of them, and those of a table whose
/// ends no samples have written.
constexpr int all_columns = 6;
constexpr int columns_without_writers = 4;

/// Has the table that is drawn now the numbers of pixels? Without room they make way for who wrote
/// the ends: they can be counted from these.
bool has_counts() {
    return ImGui::TableGetColumnCount() != all_columns - 1;
}

/// Do samples write the ends of the rows, so that there is somebody to name?
bool has_writers(const Ui& ui) {
    return walks_edges(ui.results.a.frame.stages);
}

/// How many pixels the row has. Of a row in several stretches each is counted by itself: what lies
/// between them is outside.
void draw_count(const Ui& ui, int index) {
    const Palette& p = palette(ui.options.theme);
    const RowHistory& history = ui.results.a.rows;
    const int count = history.rows.pixel_count(index);
    const std::span<const InsideSpan> spans = spans_of_row(history, history.rows.first_row + index);
    if (count == 0 || spans.size() < 2) {
        right_aligned(count > 0 ? std::to_string(count) : "—", count > 0 ? p.text : p.dim);
        return;
    }
    std::string counts, columns;
    for (const InsideSpan& span : spans) {
        const int first = span.left.column, last = span.right.column;
        counts.append(counts.empty() ? "" : " + ").append(whole_text(last - first + 1));
        columns.append(columns.empty() ? "" : " and ")
            .append(whole_text(first) + " to " + whole_text(last));
    }
    right_aligned(counts, colour_of(Meaning::fail, ui.options.theme));
    if (ImGui::IsItemHovered())
        draw_tooltip(ui, "Inside are the columns " + columns +
                             ": the polygon has a dent. The table has one left and one right end, "
                             "so the row is drawn from the first to the last.");
}

void draw_row(Ui& ui, int index) {
    const Palette& p = palette(ui.options.theme);
    const RowHistory& history = ui.results.a.rows;
    const int row = history.rows.first_row + index;
    const std::string name = "rows." + std::to_string(row);
    const EndWriter& left = history.left_by[index];
    const EndWriter& right = history.right_by[index];
    const std::optional<int> at_work = row_at_work(ui);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(row);
    const bool lit = at_work == row || ui.session.selection.row == row ||
                     ui.canvas.hovered_row == row ||
                     (ui.canvas.hovered_pixel && ui.canvas.hovered_pixel->y == row);
    if (ImGui::Selectable("##row", lit,
                          ImGuiSelectableFlags_SpanAllColumns |
                              ImGuiSelectableFlags_AllowItemOverlap)) {
        ui.session.selection.row = row;
    }
    if (ImGui::IsItemHovered()) ui.inspector.hovered_row = row;
    name_widget(ui, name,
                "Row " + whole_text(row) + " of the picture: " + element_name(entry_form, index) +
                    " of leftPixels and rightPixels.");
    if (at_work == row) {
        draw_current_bar(ui, ImGui::GetWindowDrawList(),
                         {ImGui::GetWindowPos().x, ImGui::GetItemRectMin().y},
                         ImGui::GetItemRectMax().y);
    }
    ImGui::SameLine(0.0f, 0.0f);
    right_aligned(whole_text(row), p.text);
    keep_item_whole(ui);
    ImGui::PopID();
    const RowWrite write = just_written(ui, row);
    // Coverage that walks no edges has ends that nobody wrote.
    const auto has_values = [&](const EndWriter& writer) {
        return writer.is_set() || (history.sample_count == 0 && !history.rows.is_empty_row(index));
    };
    ImGui::TableNextColumn();
    draw_end_cell(ui, name + ".left", history.rows.left[index], left, true, write.left);
    if (ui.inspector.shows_end_values) draw_values(ui, history.rows.left[index], has_values(left));
    ImGui::TableNextColumn();
    draw_end_cell(ui, name + ".right", history.rows.right[index], right, false, write.right);
    if (ui.inspector.shows_end_values) {
        draw_values(ui, history.rows.right[index], has_values(right));
        return;
    }
    if (has_counts()) {
        ImGui::TableNextColumn();
        draw_count(ui, index);
    }
    if (!has_writers(ui)) return;
    ImGui::TableNextColumn();
    draw_writer_cell(ui, name + ".left_by", left);
    ImGui::TableNextColumn();
    draw_writer_cell(ui, name + ".right_by", right);
}

/// A sample that fell outside the table: a red line, with the float value that is to blame.
void draw_outside(Ui& ui, const OutsideSample& sample, int number) {
    const ImVec4 red = colour_of(Meaning::fail, ui.options.theme);
    ImGui::TableNextRow();
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, packed(red, 0.18f));
    ImGui::TableNextColumn();
    ImGui::PushID(-1 - number);
    const bool pressed = ImGui::Selectable("##outside", false,
                                           ImGuiSelectableFlags_SpanAllColumns |
                                               ImGuiSelectableFlags_AllowItemOverlap);
    const std::string value = "y = " + nine_digits_shown(sample.y);
    const std::string tooltip = fmt::format(
        "{}: {} becomes row {}, which the table does not have. A program without a guard writes to "
        "{} here, outside its arrays.",
        sample_name(sample.edge, sample.sample), value, whole_text(sample.row),
        element_name(entry_form, sample.row - ui.results.a.rows.rows.first_row));
    name_widget(ui, "rows.outside." + std::to_string(number), tooltip);
    ImGui::PopID();
    ImGui::SameLine(0.0f, 0.0f);
    right_aligned(fixed(sample.row, 0), red);
    ImGui::TableNextColumn();
    right_aligned(ui.inspector.is_narrow ? "out" : "outside", red);
    ImGui::TableNextColumn();
    // The value is longer than a column, and the next ones are empty on this line.
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 low = ImGui::GetWindowPos();
    ImGui::PushClipRect(low, {low.x + ImGui::GetWindowWidth(), low.y + ImGui::GetWindowHeight()},
                        false);
    ImGui::GetWindowDrawList()->AddText(at, packed(red), value.c_str());
    ImGui::PopClipRect();
    if (!ui.inspector.shows_end_values) {
        ImGui::TableSetColumnIndex(ImGui::TableGetColumnCount() - 1);
        right_aligned(sample_text(sample.edge, sample.sample), red);
    }
    if (pressed) go_to_sample(ui, sample.edge, sample.sample);
}

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
        {"left by",
         "Who wrote the left end: e1 [4] is edge 1, line[4]. ↻ tells how often it was replaced."},
        {"right by",
         "Who wrote the right end: e1 [4] is edge 1, line[4]. ↻ tells how often it was replaced."},
    };
    static constexpr Header values[] = {
        {"row", "Row of the picture. Row minus first row is the entry i of both arrays."},
        {"left", "Column of the row's left end: leftPixels[i].x"},
        {weight_word, "What values are weighed by, at the left end."},
        {"x", "Varying of the left end; divided by z or w with perspective correction."},
        {"y", "Varying of the left end; divided by z or w with perspective correction."},
        {"z", "Varying of the left end; divided by z or w with perspective correction."},
        {"right", "Column of the row's right end: rightPixels[i].x"},
        {weight_word, "What values are weighed by, at the right end."},
        {"x", "Varying of the right end; divided by z or w with perspective correction."},
        {"y", "Varying of the right end; divided by z or w with perspective correction."},
        {"z", "Varying of the right end; divided by z or w with perspective correction."},
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
        ImGui::PushFont(ui.fonts.small);
        right_aligned(title, palette(ui.options.theme).dim);
        ImGui::PopFont();
        // The values of both ends have the same titles.
        const bool is_value = ui.inspector.shows_end_values && i >= 2 && i != 6;
        const std::string end = !is_value ? "" : i < 6 ? "left." : "right.";
        name_widget(ui, "rows.header." + end + headers[i].name, headers[i].help);
    }
}

/// Begins a table with the columns of the row table; false if nothing of it is to be drawn.
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
    const bool counts =
        !is_narrow && writer_width >= widest_writer(ui) + sign_gap * u + width_of_sign(ui);
    const int columns = has_values         ? 11
                        : !has_writers(ui) ? columns_without_writers
                        : counts           ? all_columns
                                           : all_columns - 1;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, cell_padding);
    const bool open =
        ImGui::BeginTable(name, columns,
                          flags | ImGuiTableFlags_BordersInnerH |
                              (has_values ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit
                                          : ImGuiTableFlags_SizingStretchProp),
                          size);
    ImGui::PopStyleVar();
    if (!open) return false;
    static constexpr float narrow[] = {28, 42, 42, 90, 90};
    const float* const widths = counts || !has_writers(ui) ? roomy : narrow;
    for (int i = 0; i < columns; ++i) {
        // Of the ends' values those of the left end are in sight at once.
        const float value_width = i == 0 ? 40.0f : i == 1 || i == 6 ? 46.0f : 70.0f;
        ImGui::TableSetupColumn("", 0, has_values ? value_width * u : widths[i]);
    }
    return true;
}

/// @param height of what scrolls to the row at work or to a wanted one; none: nothing does
void draw_all_rows(Ui& ui, std::optional<float> height) {
    const RowHistory& history = ui.results.a.rows;
    ImGui::PushFont(ui.fonts.mono);
    const auto is_above = [&](const OutsideSample& s) { return s.row < history.rows.first_row; };
    for (std::size_t i = 0; i < history.outside.size(); ++i) {
        if (is_above(history.outside[i])) draw_outside(ui, history.outside[i], static_cast<int>(i));
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
        clipper.ForceDisplayRangeByIndices(index, index + 1);
    }
    const int wanted = height ? wanted_row(ui, *height) : -1;
    if (wanted < 0 || wanted >= history.rows.size()) {
        ui.inspector.scroll_to_row = false;
    } else {
        clipper.ForceDisplayRangeByIndices(wanted, wanted + 1);
    }
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_row(ui, i);
            const bool is_at_work = at_work == history.rows.first_row + i;
            if (follows && is_at_work && !ImGui::IsItemVisible()) scroll_to_line(above + i, line);
            if (i == wanted) bring_into_view(ui, above + i, line, i + 1 == history.rows.size());
        }
    }
    for (std::size_t i = 0; i < history.outside.size(); ++i) {
        if (!is_above(history.outside[i])) {
            draw_outside(ui, history.outside[i], static_cast<int>(i));
        }
    }
    ImGui::PopFont();
}

} // namespace

void draw_row_table(Ui& ui, float height) {
    // Whole lines, if it is to be scrolled.
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
    // The same width in both, whether the rows need a scroll bar or not.
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    if (begin_row_table(ui, "rows.head", 0, {width, 0})) {
        draw_row_headers(ui);
        ImGui::EndTable();
    }
    const float height = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("rows.body", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_whole_lines(ui);
    if (begin_row_table(ui, "rows", 0, {width, 0})) {
        draw_all_rows(ui, height);
        ImGui::EndTable();
    }
    ImGui::PushTextWrapPos(width);
    below();
    ImGui::PopTextWrapPos();
    end_whole_lines(ui);
    ImGui::EndChild();
}

} // namespace rasterwalk
