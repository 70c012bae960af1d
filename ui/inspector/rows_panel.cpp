#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "ui/inspector/panels.h"
#include "ui/inspector/rows_parts.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The row whose fragments are being drawn, once the table is done: its ends, and how far it is.
void draw_row_in_work(Ui& ui, const Cursor& done) {
    const RunResults& a = ui.results.a;
    const Palette& p = palette(ui.options.theme);
    const auto i = static_cast<std::size_t>(done.index);
    const int left = a.rows.rows.left[i].column, right = a.rows.rows.right[i].column;
    text_in(p.dim, walks_edges(a.frame.stages) ? "all samples are entered, now the rows: "
                                               : "the pixels are found, now the rows: ");
    wrapped_text("row " + whole_text(a.rows.rows.first_row + done.index) + ", " +
                 element_name_of(entry_form, done.index, a.rows.rows.size()));
    put_text(fmt::format("left = {}, right = {}", left, right), ui.fonts.mono);
    wrapped_text(has_fragments(a.frame.settings.stage)
                     ? "now the pixel in column " + whole_text(left + done.step)
                     : "its two ends are drawn");
}

/// What the moment did, in words and numbers: the last sample entered, or the row.
void draw_moment(Ui& ui) {
    const RowHistory& history = ui.results.a.rows;
    const Palette& p = palette(ui.options.theme);
    begin_card(ui);
    const std::optional<Cursor>& done = ui.results.a.done;
    const bool is_of_triangle = done && done->triangle == ui.results.a.triangle;
    if (is_of_triangle && done->phase == Phase::rows) {
        draw_row_in_work(ui, *done);
        end_card(ui);
        return;
    }
    const RunResults& a = ui.results.a;
    if (a.triangle && a.frame.is_drawn(*a.triangle) && !walks_edges(a.frame.stages)) {
        ImGui::PushStyleColor(ImGuiCol_Text, p.dim);
        wrapped_text(a.frame.has_samples()
                         ? "Edges have no samples; a row holds the pixels of which a sample is "
                           "inside."
                         : "There are no samples; a row holds the pixels whose centres are "
                           "inside.");
        if (tests_pixels(a.frame.stages)) {
            wrapped_text("Step, or pick a pixel that has been tested, to see it explained here.");
        }
        ImGui::PopStyleColor();
        end_card(ui);
        return;
    }
    if (!history.last) {
        text_in(p.dim, "No sample has been entered yet, so every row is empty.");
        end_card(ui);
        return;
    }
    const EdgeSample& last = *history.last;
    text_in(p.dim, "last sample: ");
    ImGui::SameLine(0.0f, 0.0f);
    text_in(colour_of(edge_meaning(last.edge), ui.options.theme), edge_name(last.edge));
    ImGui::SameLine(0.0f, 0.0f);
    text_in(p.dim,
            ", " + element_name_of(sample_form, last.sample,
                                   history.edge_samples[static_cast<std::size_t>(last.edge)]));
    ImGui::PushFont(ui.fonts.mono);
    const auto show = [&](const char* axis, float place, int pixel) {
        const std::string line =
            fmt::format("{} = {} → {}", axis, nine_digits_shown(place), whole_text(pixel));
        put_text(line);
    };
    show("x", last.x, last.fragment.column);
    show("y", last.y, last.fragment.row);
    ImGui::PopFont();
    std::string words = "row " + whole_text(last.fragment.row);
    if (last.write.inside) {
        words += ", " + element_name(entry_form, history.last_index);
    }
    words += ": ";
    if (!last.write.inside) {
        words += "outside the table, not written";
        text_in(colour_of(Meaning::fail, ui.options.theme), words);
    } else {
        const std::string column = whole_text(last.fragment.column);
        words += last.write.left && last.write.right ? "both ends become " + column
                 : last.write.left                   ? "left end becomes " + column
                 : last.write.right                  ? "right end becomes " + column
                                                     : "lies between its ends, so nothing changes";
        wrapped_text(words);
    }
    end_card(ui);
}

constexpr const char *copy_label = "copy as text", *values_label = "ends' values";

std::string words_of_outside(const RowHistory& history) {
    const bool is_finished = history.samples == history.sample_count;
    return counted(static_cast<std::int64_t>(history.outside.size()), "sample outside",
                   "samples outside") +
           (is_finished ? "" : " so far");
}

/// Do the buttons below the table have room on a line with the words next to them?
bool has_one_line_of_buttons(const RowHistory& history) {
    const float needed = button_width(copy_label) + button_width(values_label) +
                         text_width(words_of_outside(history)) +
                         2.0f * ImGui::GetStyle().ItemSpacing.x;
    return needed <= ImGui::GetContentRegionAvail().x;
}

/// What can be done with the table, and how many samples are not in it.
/// @param is_one_line leaves the count out if it has no room next to the buttons: the samples
///                    outside are lines of the table
void draw_table_buttons(Ui& ui, bool is_one_line) {
    const Palette& p = palette(ui.options.theme);
    const RowHistory& history = ui.results.a.rows;
    const bool has_room = has_one_line_of_buttons(history);
    if (button(ui, "rows.copy", copy_label, Look::plain,
               "Copies the table in the form that the lab prints.")) {
        ImGui::SetClipboardText(rows_text(history.rows).c_str());
        show_info(ui.session, "The row table is on the clipboard.");
    }
    ImGui::SameLine();
    if (button(ui, "rows.values", values_label,
               ui.inspector.shows_end_values ? Look::chosen : Look::plain,
               "Shows " + std::string(weight_name(ui.results.a.frame)) +
                   " and the varyings of both ends in additional columns.")) {
        ui.inspector.shows_end_values = !ui.inspector.shows_end_values;
    }
    // Without samples none can be outside.
    if (!walks_edges(ui.results.a.frame.stages)) return;
    if (is_one_line && !has_room) return;
    if (has_room) ImGui::SameLine();
    text_in(history.outside.empty() ? p.dim : colour_of(Meaning::fail, ui.options.theme),
            words_of_outside(history));
    register_widget(ui, "rows.outside",
                    "Samples of this triangle so far that fell in no row of the table.");
}

/// The tested pixel first, and below it the rows found so far. What has no room is scrolled to.
/// @param needed the height of the whole table
void draw_inside(Ui& ui, const PixelTest& test, float needed) {
    draw_pixel_test(ui, test);
    const bool has_pictures = has_coverage_pictures(ui);
    if (has_pictures) draw_coverage_pictures(ui);
    const float room = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing();
    // Where lines are few, one scroll is enough; the ends' values need their own.
    const float few_lines = std::min(needed, 6.0f * ImGui::GetTextLineHeightWithSpacing());
    const bool has_few_lines = ui.inspector.is_low || (has_pictures && room < few_lines);
    if (has_few_lines && !ui.inspector.shows_end_values) {
        draw_row_table_in_page(ui);
    } else {
        const float least = ui.inspector.is_low ? needed : few_lines;
        draw_row_table(ui, std::max(std::min(needed, room), least));
    }
    draw_table_buttons(ui, false);
}

} // namespace

void draw_rows_panel(Ui& ui) {
    if (!begin_triangle_panel(ui, "rows")) return;
    const bool is_low = ui.inspector.is_low;
    if (!is_low) draw_bench_examples(ui);
    const RowHistory& history = ui.results.a.rows;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float slack = 10.0f * ui.options.text_scale; // the lines between the rows
    const float needed = slack +
                         static_cast<float>(history.rows.size() + history.outside.size() + 1) *
                             (ui.fonts.mono->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y) +
                         (ui.inspector.shows_end_values ? ImGui::GetStyle().ScrollbarSize : 0.0f);
    if (const std::optional<PixelTest> test = shown_test(ui)) {
        draw_inside(ui, *test, needed);
        return;
    }
    const bool has_pictures = has_coverage_pictures(ui);
    // Where there are few lines they are scrolled to.
    const bool are_pictures_below = has_pictures && !ui.inspector.has_card;
    if (has_pictures && !are_pictures_below) draw_coverage_pictures(ui);
    const float buttons = ImGui::GetFrameHeightWithSpacing();
    const float all = ImGui::GetContentRegionAvail().y;
    const float room = all - 6.2f * line - buttons;
    if (!is_low && !are_pictures_below && room >= std::min(needed, 6.0f * line)) {
        draw_row_table(ui, std::min(needed, room));
        draw_moment(ui);
        draw_table_buttons(ui, false);
        return;
    }
    if (ui.inspector.shows_end_values) {
        // With more columns than there is room for, the table scrolls both ways; then nothing else
        // does.
        draw_row_table(ui, std::max(std::min(needed, all - buttons), 3.0f * line));
        draw_table_buttons(ui, true);
        return;
    }
    // Where there are few lines the table has them; the rest is scrolled to.
    draw_row_table_with(ui, [&] {
        draw_moment(ui);
        draw_table_buttons(ui, false);
        if (are_pictures_below) draw_coverage_pictures(ui);
        if (is_low) draw_bench_examples(ui);
    });
}

} // namespace rasterwalk
