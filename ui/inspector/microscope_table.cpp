#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/line_rules.h"
#include "ui/inspector/microscope_parts.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// How many samples of the shown edge come before the cursor.
int samples_walked(const Ui& ui) {
    const Cursor begin{*ui.results.a.triangle, Phase::edges, ui.inspector.microscope.edge, 0};
    if (ui.results.a.cursor <= begin) return 0;
    const int current = current_sample(ui);
    return current >= 0 ? current + 1 : ui.inspector.microscope.shown.count;
}

std::string coordinate_words(const char* axis, const char* pixel, const MicroscopeCoordinate& c) {
    std::string text = std::string(axis) + " = " + nine_digits_shown(c.walked) + ", exactly " +
                       fraction_text(c.exact);
    if (c.exact.denominator != 1)
        text += " = " + with_minus_signs(significant(c.exact.value(), 12));
    text += "\n     " + std::string(pixel) + " " + whole_text(c.pixel);
    if (c.differs_from_exact()) text += ", where the exact one is " + whole_text(c.exact_pixel);
    if (c.differs_from_reverse()) text += "; walked backward: " + whole_text(c.reverse_pixel);
    return text;
}

/// Everything there is to say about a sample.
std::string sample_words(const Ui& ui, const MicroscopeSample& sample) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    std::string text = sample_name(ui.inspector.microscope.edge, sample.sample) + "\n" +
                       coordinate_words("x", "column", sample.x) + "\n" +
                       coordinate_words("y", "row", sample.y);
    if (edge.decides()) {
        const LineAlgorithm line = ui.results.a.frame.settings.line;
        text += "\n" + with_minus_signs(decision_words(edge, line, sample.sample));
    }
    return text + "\nClick to go to the moment when it was entered.";
}

/// A whole pixel; one that differs from what it is compared with is marked.
void draw_pixel_cell(const Ui& ui, int pixel, bool differs, const ImVec4& quiet) {
    if (differs) {
        right_aligned("≠ " + whole_text(pixel), colour_of(Meaning::fail, ui.options.theme));
    } else {
        right_aligned(whole_text(pixel), quiet);
    }
}

/// Numbers of the columns that a narrow panel has no room for; the tooltip of a line gives their
/// values.
constexpr int exact_column = 2, drift_column = 3;

/// Columns that only some lines have: a float, a decision variable, a step that was decided.
constexpr int float_column = 1, decision_column = 6, chosen_step_column = 7;

struct SampleColumn {
    int number; ///< from the left, if all are shown
    const char* title;
    const char* help;
    int letters; ///< of its widest number
};

using SampleColumns = std::vector<SampleColumn>;

bool has(const SampleColumns& columns, int number) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const SampleColumn& column) { return column.number == number; });
}

/// The cells of a sample's decision.
void draw_decision(const LineDecision& decision, const SampleColumns& columns, const ImVec4& ink) {
    if (has(columns, decision_column)) {
        ImGui::TableNextColumn();
        right_aligned(with_minus_signs(decision_number(decision.before)), ink);
    }
    ImGui::TableNextColumn();
    right_aligned(decision.step == PixelStep::none ? "–" : std::string(word_of(decision.step)),
                  ink);
}

void draw_sample(Ui& ui, const SampleColumns& columns, int index, int current, int walked) {
    const Palette& p = palette(ui.options.theme);
    const MicroscopeSample sample = ui.inspector.microscope.shown.at(index);
    const MicroscopeCoordinate& c = shown_coordinate(ui, sample);
    const ImVec4& ink = index < walked ? p.text : p.dim;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(index);
    if (selectable_row("##sample", index == current)) {
        go_to_sample(ui, index);
    }
    clip_to_lines();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui.inspector.hovered_row = sample.y.pixel;
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const std::string tooltip = hovered ? sample_words(ui, sample) : std::string();
    register_widget(ui, "microscope.sample." + std::to_string(index), tooltip);
    ImGui::SameLine(0.0f, 0.0f);
    right_aligned(std::to_string(index), ink);
    ImGui::PopID();
    if (has(columns, float_column)) {
        ImGui::TableNextColumn();
        right_aligned(float_text(c.walked), ink);
    }
    if (edge.decides())
        draw_decision(edge.decisions[static_cast<std::size_t>(index)], columns, ink);
    if (has(columns, exact_column)) {
        ImGui::TableNextColumn();
        right_aligned(mixed_text(c.exact), ink);
    }
    if (has(columns, drift_column)) {
        ImGui::TableNextColumn();
        // With a decision variable half a pixel is usual; without one, a millionth.
        right_aligned(edge.has_decision_variable() ? with_minus_signs(significant(c.drift, 3))
                                                   : drift_text(c.drift),
                      c.drift == 0.0 ? p.dim : ink);
    }
    ImGui::TableNextColumn();
    draw_pixel_cell(ui, c.pixel, c.differs_from_exact(), ink);
    ImGui::TableNextColumn();
    draw_pixel_cell(ui, c.reverse_pixel, c.differs_from_reverse(), p.dim);
}

int digits(std::int64_t value) {
    return static_cast<int>(whole_text(std::abs(value)).size());
}

/// The columns for x or y of this edge, each as wide as its numbers can get.
SampleColumns columns_of(const Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const bool x = ui.inspector.microscope.shows_x;
    const int a = x ? edge.a.column : edge.a.row, b = x ? edge.b.column : edge.b.row;
    const std::int64_t denominator = (x ? edge.step_x : edge.step_y).denominator;
    const double drift = x ? edge.summary.largest_drift_x : edge.summary.largest_drift_y;
    const int sign = std::min(a, b) < 0 ? 1 : 0;
    const int whole = sign + digits(std::max(std::abs(a), std::abs(b)));
    const int fraction = denominator == 1 ? 0 : 2 + 2 * digits(denominator);
    const int exact = std::max(5, whole + fraction);
    SampleColumns columns{{0, "i", "Number of the sample along the edge, from 0: line[i].",
                           std::max(2, digits(edge.count))}};
    if (edge.has_decision_variable()) {
        const double largest = edge.summary.largest_decision;
        columns.push_back({decision_column, "d",
                           "The decision variable at this sample: its sign chooses the next step.",
                           std::max(3, static_cast<int>(decision_number(largest).size()) + 2)});
    } else {
        columns.push_back({float_column, x ? "x float" : "y float",
                           "The value that the walk carries, in nine digits: enough to tell every "
                           "float from its neighbours.",
                           denominator == 1 ? std::max(whole, 7) : 11 + sign});
    }
    if (edge.decides()) {
        columns.push_back({chosen_step_column, "step",
                           "Where the line goes from this sample: straight along its longer axis, "
                           "or diagonally.",
                           8});
    }
    const bool decided = edge.has_decision_variable();
    const SampleColumn others[] = {
        {exact_column, x ? "x exact" : "y exact",
         "Where the sample would be without any error: start + i (end - start) / steps, as a "
         "fraction in lowest terms.",
         exact},
        {drift_column, decided ? "off" : "drift",
         decided ? "Where the sample is minus where the line is: half a pixel at most."
                 : "Float minus exact: what the additions have lost on the way here.",
         drift == 0.0 ? 4 : 9},
        {4, x ? "column" : "row",
         decided ? "The pixel of the sample. ≠: another pixel is nearer to the line."
                 : "The pixel that the float becomes. ≠: the exact position is on another pixel.",
         std::max(5, whole + 2)},
        {5, "reverse",
         "The pixel of this sample when the edge is walked from its end to its start. ≠: a "
         "different one from walking forward.",
         std::max(5, whole + 2)}};
    columns.insert(columns.end(), std::begin(others), std::end(others));
    return columns;
}

/// The width of the table, screen pixels.
float width_of(const Ui& ui, const SampleColumns& columns, float padding) {
    ImGui::PushFont(ui.fonts.mono);
    const float letter = ImGui::CalcTextSize("0").x;
    ImGui::PopFont();
    float width = 0.0f;
    for (const SampleColumn& column : columns)
        width += letter * static_cast<float>(column.letters) + 2.0f * padding;
    return width;
}

void draw_sample_headers(Ui& ui, const SampleColumns& columns) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i));
        right_aligned(columns[i].title, palette(ui.options.theme).dim, ui.fonts.small);
        register_widget(ui, "microscope.header." + std::to_string(columns[i].number),
                        columns[i].help);
    }
}

/// The columns that fit.
SampleColumns fitting_columns(const Ui& ui, float room, float padding) {
    SampleColumns columns = columns_of(ui);
    for (const int number : {drift_column, exact_column}) {
        if (width_of(ui, columns, padding) <= room) break;
        std::erase_if(columns, [&](const SampleColumn& c) { return c.number == number; });
    }
    return columns;
}

/// False if none of it is to be drawn.
bool begin_samples(const char* name, const SampleColumns& columns, ImGuiTableFlags flags,
                   ImVec2 size) {
    const bool is_open = begin_lined_table(
        name, static_cast<int>(columns.size()),
        flags | ImGuiTableFlags_PadOuterX | ImGuiTableFlags_SizingStretchProp, size);
    if (!is_open) return false;
    for (const SampleColumn& column : columns) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch,
                                static_cast<float>(column.letters));
    }
    return true;
}

void draw_samples(Ui& ui, const SampleColumns& columns, bool appears) {
    const int count = ui.inspector.microscope.shown.count;
    ImGui::PushFont(ui.fonts.mono);
    const int current = current_sample(ui), walked = samples_walked(ui);
    ImGuiListClipper clipper;
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    clipper.Begin(count, line);
    const bool follows = (ui.follow_cursor || appears) && current >= 0 && current < count;
    if (follows) keep_items(clipper, current, current + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_sample(ui, columns, i, current, walked);
            if (follows && i == current && !ImGui::IsItemVisible()) scroll_to_line(i, line);
        }
    }
    ImGui::PopFont();
}

/// The padding of a cell, screen pixels.
ImVec2 sample_padding(const Ui& ui) {
    return {4.0f * ui.options.text_scale, ImGui::GetStyle().CellPadding.y};
}

} // namespace

void draw_sample_table(Ui& ui, float height, bool appears) {
    const ImVec2 padding = sample_padding(ui);
    // Whole lines, so that the table begins with one even when scrolled to its end.
    const float head = ui.fonts.small->FontSize + 2.0f * padding.y;
    const float line = ui.fonts.mono->FontSize + 2.0f * padding.y;
    height = head + std::max(std::floor((height - head) / line), 1.0f) * line;
    const SampleColumns columns = fitting_columns(
        ui, ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize, padding.x);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, padding);
    if (begin_samples("samples", columns, ImGuiTableFlags_ScrollY, {0, height})) {
        ImGui::TableSetupScrollFreeze(1, 1);
        draw_sample_headers(ui, columns);
        draw_samples(ui, columns, appears);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

void draw_sample_table_with(Ui& ui, bool appears, const std::function<void()>& below) {
    // The same width in both, whether or not the samples need a scroll bar.
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    const ImVec2 padding = sample_padding(ui);
    const SampleColumns columns = fitting_columns(ui, width, padding.x);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, padding);
    if (begin_samples("samples.head", columns, 0, {width, 0})) {
        draw_sample_headers(ui, columns);
        ImGui::EndTable();
    }
    ImGui::BeginChild("samples.body", {0, 0}, false, ImGuiWindowFlags_NoNav);
    begin_line_clip();
    if (begin_samples("samples", columns, 0, {width, 0})) {
        draw_samples(ui, columns, appears);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::PushTextWrapPos(width);
    below();
    ImGui::PopTextWrapPos();
    end_line_clip();
    ImGui::EndChild();
}

} // namespace rasterwalk
