#include "ui/inspector/rows_lines.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/row_ends.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Is the last item, which lies on the button of its row, clicked?
bool is_clicked_on_row() {
    return ImGui::IsMouseClicked(0) &&
           ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

/// One end of a row: its column, in the colour of what wrote it; in a box if that has just
/// happened.
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
        draw_box_around(ui, ImGui::GetWindowDrawList(), low,
                        {low.x + width, low.y + ImGui::GetTextLineHeight()},
                        palette(ui.options.theme).changed);
    }
    register_widget(ui, name, end_tooltip(ui, end, writer));
    if (writer.is_set() && is_clicked_on_row()) go_to_sample(ui, writer.edge, writer.sample);
}

/// Before the sign that shows how often an end was replaced, design pixels.
constexpr float sign_gap = 4.0f;

float width_of_sign(const Ui& ui) {
    return text_width(ui.fonts.small, "↻0");
}

/// The width of the longest name of a sample of the triangle shown.
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
    // How often it was replaced is set apart, in small letters after the writer; if there is no
    // room for it, the tooltip says it.
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
    register_widget(ui, name, writer_tooltip(writer));
    if (is_clicked_on_row()) go_to_sample(ui, writer.edge, writer.sample);
    if (!has_sign || writer.replaced == 0 || writer.replaced > 9) return;
    ImGui::SameLine(0.0f, gap);
    text_in(p.dim, "↻" + std::to_string(writer.replaced), ui.fonts.small);
    register_widget(ui, name + ".replaced", replaced_tooltip(writer));
}

/// The varying that the stage uses; if it uses none, the first: the position in the room.
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

/// How many pixels the row has. If a row has several stretches, each is counted separately: what
/// lies between them is outside.
void draw_count(const Ui& ui, int index) {
    const Palette& p = palette(ui.options.theme);
    const RowHistory& history = ui.results.a.rows;
    const int count = row_span(ui.results.a.frame.stages, history.rows, index).count;
    const std::span<const InsideSpan> spans = spans_of_row(history, history.rows.first_row + index);
    if (count <= 0 || spans.size() < 2) {
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
        draw_tooltip(ui, "Columns " + columns +
                             " are inside because the polygon has a dent. The table has one left "
                             "and one right end, so the row is drawn from the first column to "
                             "the last.");
}

} // namespace

bool has_writers(const Ui& ui) {
    return walks_edges(ui.results.a.frame.stages);
}

bool has_counts() {
    return ImGui::TableGetColumnCount() != all_row_columns - 1;
}

float width_of_writer(const Ui& ui) {
    return widest_writer(ui) + sign_gap * ui.options.text_scale + width_of_sign(ui);
}

void draw_row_line(Ui& ui, int index) {
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
    if (selectable_row("##row", lit)) {
        ui.session.selection.row = row;
    }
    if (ImGui::IsItemHovered()) ui.inspector.hovered_row = row;
    register_widget(ui, name,
                    "Row " + whole_text(row) + " of the picture: " +
                        element_name(entry_form, index) + " of leftPixels and rightPixels.");
    if (at_work == row) {
        draw_current_bar(ui, ImGui::GetWindowDrawList(),
                         {ImGui::GetWindowPos().x, ImGui::GetItemRectMin().y},
                         ImGui::GetItemRectMax().y);
    }
    ImGui::SameLine(0.0f, 0.0f);
    right_aligned(whole_text(row), p.text);
    ImGui::PopID();
    const RowWrite write = just_written(ui, row);
    // Coverage that walks no edges has ends that no sample wrote.
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

void draw_outside_line(Ui& ui, const OutsideSample& sample, int number) {
    const ImVec4 red = colour_of(Meaning::fail, ui.options.theme);
    ImGui::TableNextRow();
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, packed(red, 0.18f));
    ImGui::TableNextColumn();
    ImGui::PushID(-1 - number);
    const bool pressed = selectable_row("##outside", false);
    const std::string value = "y = " + nine_digits_shown(sample.y);
    const std::string tooltip = fmt::format(
        "{}: {} becomes row {}, which the table does not have. A program without a guard writes to "
        "{} here, outside its arrays.",
        sample_name(sample.edge, sample.sample), value, whole_text(sample.row),
        element_name(entry_form, sample.row - ui.results.a.rows.rows.first_row));
    register_widget(ui, "rows.outside." + std::to_string(number), tooltip);
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

} // namespace rasterwalk
