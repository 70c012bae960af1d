#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "session/walk.h"
#include "ui/panels/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace rasterwalk {

namespace {

/// A number as the C library prints it, with true minus signs.
std::string printed(const char* format, double value) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, format, value);
    std::string text;
    for (const char* c = buffer; *c != '\0'; ++c)
        text += *c == '-' ? std::string("−") : std::string(1, *c);
    return text;
}

/// Nine digits tell every float from its neighbours.
std::string nine_digits(float value) {
    return printed("%.9g", static_cast<double>(value));
}

/// The same for a narrow column: what is left over near zero gets three digits.
std::string float_text(float value) {
    const bool is_leftover = value != 0.0f && std::abs(value) < 1e-4f;
    return is_leftover ? printed("%.2e", static_cast<double>(value)) : nine_digits(value);
}

std::string drift_text(double drift) {
    return drift == 0.0 ? "0" : printed("%.2e", drift);
}

std::string whole_text(std::int64_t value) {
    return (value < 0 ? "−" : "") + std::to_string(std::abs(value));
}

/// "−2 1/3": the whole part first, because it is the pixel.
std::string mixed_text(const Fraction& f) {
    if (f.denominator == 1) return whole_text(f.numerator);
    const std::int64_t size = std::abs(f.numerator);
    std::string text = f.numerator < 0 ? "−" : "";
    if (size >= f.denominator) text.append(std::to_string(size / f.denominator)).append(" ");
    return text + to_text(Fraction{size % f.denominator, f.denominator});
}

std::string fraction_text(const Fraction& f) {
    const std::string sign = f.numerator < 0 ? "−" : "";
    return sign + to_text(Fraction{std::abs(f.numerator), f.denominator});
}

std::string place_text(int column, int row) {
    return "(" + whole_text(column) + "," + whole_text(row) + ")";
}

std::string counted(std::size_t count, int of) {
    return std::to_string(count) + " of " + std::to_string(of) + (of == 1 ? " sample" : " samples");
}

/// The sample of the shown edge that was entered last; -1: the cursor is not on this edge.
int current_sample(const Ui& ui) {
    const std::optional<Cursor>& done = ui.results.done;
    const bool is_here = done && done->triangle == *ui.results.triangle &&
                         done->phase == Phase::edges && done->index == ui.microscope.edge;
    return is_here ? done->step : -1;
}

/// How many samples of the shown edge come before the cursor.
int samples_walked(const Ui& ui) {
    const Cursor begin{*ui.results.triangle, Phase::edges, ui.microscope.edge, 0};
    if (ui.results.cursor <= begin) return 0;
    const int current = current_sample(ui);
    return current >= 0 ? current + 1 : ui.microscope.shown.count;
}

/// To the moment just after the sample was entered.
void go_to_sample(Ui& ui, int sample) {
    const Timeline timeline(ui.results.frame);
    const Cursor cursor{*ui.results.triangle, Phase::edges, ui.microscope.edge, sample};
    if (timeline.exists(cursor)) go_to(ui.session, timeline.next(cursor, Granularity::moment));
}

/// The edge that was picked, until the cursor comes to another.
void look_at_edge(Ui& ui) {
    MicroscopeView& view = ui.microscope;
    const std::optional<Cursor>& done = ui.results.done;
    if (view.picked_at != ui.results.cursor && done && done->phase == Phase::edges &&
        done->triangle == *ui.results.triangle) {
        view.edge = done->index;
    }
    const Frame& frame = ui.results.frame;
    const std::span<const Fragment> v = frame.triangle_vertices(*ui.results.triangle);
    const Fragment& a = v[static_cast<std::size_t>(view.edge)];
    const Fragment& b = v[static_cast<std::size_t>((view.edge + 1) % 3)];
    const EdgeRules rules = edge_rules(frame.settings);
    if (!view.shown.shows(a, b, rules)) view.shown = microscope(a, b, rules);
    const std::pair<int, int> edge{*ui.results.triangle, view.edge};
    if (view.axis_chosen_for == edge) return;
    // One of the two steps by whole pixels and never drifts: the other one is worth looking at.
    const MicroscopeSummary& summary = view.shown.summary;
    view.shows_x = summary.largest_drift_y == 0.0 && summary.largest_drift_x != 0.0;
    view.axis_chosen_for = edge;
}

/// Continues the line if a button with this label has room on it.
void same_line_if_room(const std::string& label, float gap) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + gap + button_width(label) <= right) ImGui::SameLine(0, gap);
}

void draw_buttons(Ui& ui) {
    MicroscopeView& view = ui.microscope;
    const float u = ui.options.text_scale;
    // In a narrow column the tooltips have to say what the signs mean.
    const bool is_narrow = ImGui::GetContentRegionAvail().x < 340.0f * u;
    const float gap = is_narrow ? 8.0f * u : 18.0f * u;
    for (int e = 0; e < 3; ++e) {
        const std::string label = (is_narrow ? "" : "edge ") + std::to_string(e + 1);
        if (e > 0) same_line_if_room(label, 6.0f * u);
        if (button(ui, "microscope.edge." + std::to_string(e), label,
                   e == view.edge ? Look::chosen : Look::plain,
                   "Puts edge " + std::to_string(e + 1) +
                       " of the triangle under the microscope.")) {
            view.edge = e;
            view.picked_at = ui.results.cursor;
        }
    }
    same_line_if_room("x", gap);
    if (button(ui, "microscope.x", "x", view.shows_x ? Look::chosen : Look::plain,
               "Shows x, which decides the column of a sample.")) {
        view.shows_x = true;
    }
    same_line_if_room("y", 6.0f * u);
    if (button(ui, "microscope.y", "y", view.shows_x ? Look::plain : Look::chosen,
               "Shows y, which decides the row of a sample.")) {
        view.shows_x = false;
    }
    if (view.shown.differing.empty()) return;
    const char* const next_label = is_narrow ? "≠" : "next ≠";
    same_line_if_room(next_label, gap);
    if (button(ui, "microscope.next", next_label, Look::plain,
               "Goes to the next sample that falls on another pixel than its exact place.")) {
        const int current = current_sample(ui);
        const int next = view.shown.next_difference(current + 1);
        const MicroscopeSample sample = view.shown.at(next);
        view.shows_x = !sample.y.differs_from_exact();
        go_to_sample(ui, next);
    }
}

/// A line of the card: what is in order is quiet, what is not is marked.
void draw_statement(const Ui& ui, bool in_order, const std::string& text) {
    const Palette& p = palette(ui.options.theme);
    text_in(in_order ? p.dim : colour_of(Meaning::fail, ui.options.theme),
            (in_order ? "=  " : "≠  ") + text);
}

void draw_step(const Ui& ui, const char* axis, const Fraction& step, float float_step,
               double drift) {
    const bool is_exact = static_cast<double>(float_step) * static_cast<double>(step.denominator) ==
                          static_cast<double>(step.numerator);
    std::string text = std::string(axis) + ": step " + fraction_text(step);
    text += is_exact ? ", exact in float" : ", in float " + nine_digits(float_step);
    const ImVec4& ink = palette(ui.options.theme).text;
    if (drift == 0.0) {
        text_in(ink, text);
        return;
    }
    // The line breaks between the two parts, never within a number.
    const std::string end = "drifts to " + drift_text(drift);
    const float width = ImGui::CalcTextSize((text + "; " + end).c_str()).x;
    if (width <= ImGui::CalcItemWidth()) {
        text_in(ink, text + "; " + end);
    } else {
        text_in(ink, text);
        text_in(ink, "    " + end);
    }
}

/// How many samples the floats have put on a wrong pixel.
void draw_verdict(const Ui& ui) {
    const EdgeMicroscope& edge = ui.microscope.shown;
    const std::size_t differing = edge.differing.size();
    draw_statement(ui, differing == 0,
                   differing == 0
                       ? "every sample is on its exact pixel"
                       : counted(differing, edge.count) + " on another pixel than exact");
}

const char* walk_text(LineWalk walk) {
    switch (walk) {
    case LineWalk::accumulate:
        return "each sample adds the step to the one before, in float";
    case LineWalk::multiply:
        return "sample i is the start plus i times the step, in float";
    case LineWalk::integer_step:
        return "each sample adds the step to the one before; the step is divided as int by int";
    case LineWalk::exact:
        return "pixels come from whole fractions; the floats are only shown";
    }
    return "";
}

/// What is to be seen on this edge, in words.
void draw_summary(Ui& ui) {
    const EdgeMicroscope& edge = ui.microscope.shown;
    const MicroscopeSummary& summary = edge.summary;
    const Palette& p = palette(ui.options.theme);
    begin_card(ui);
    text_in(colour_of(edge_meaning(ui.microscope.edge), ui.options.theme),
            "edge " + std::to_string(ui.microscope.edge + 1));
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextUnformatted((" from " + place_text(edge.a.column, edge.a.row) + " to " +
                            place_text(edge.b.column, edge.b.row))
                               .c_str());
    text_in(p.dim, walk_text(edge.rules.line.walk));
    draw_step(ui, "x", edge.step_x, edge.float_step_x, summary.largest_drift_x);
    draw_step(ui, "y", edge.step_y, edge.float_step_y, summary.largest_drift_y);
    draw_verdict(ui);
    if (summary.misses_end) {
        const EdgeMicroscope::Place& last = edge.forward.back();
        draw_statement(ui, false,
                       "the last is on " + place_text(last.column, last.row) +
                           " and misses the end point");
    }
    const int reverse = summary.differ_from_reverse;
    draw_statement(ui, reverse == 0,
                   reverse == 0 ? "walked backwards it has the same pixels"
                                : "walked backwards: " +
                                      counted(static_cast<std::size_t>(reverse), edge.count) +
                                      " on another pixel");
    end_card(ui);
}

const MicroscopeCoordinate& shown_coordinate(const Ui& ui, const MicroscopeSample& sample) {
    return ui.microscope.shows_x ? sample.x : sample.y;
}

/// The drift along the edge as a curve; samples on a wrong pixel are marked below it.
void draw_drift_curve(Ui& ui) {
    const EdgeMicroscope& edge = ui.microscope.shown;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = 58.0f * u;
    const ImVec2 high{low.x + width, low.y + height};
    ImGui::InvisibleButton("microscope.curve", {width, height});
    const bool is_held = ImGui::IsItemActive();
    name_widget(ui, "microscope.curve",
                "How far the float is off the exact fraction, along the edge. Marks: samples on a "
                "wrong pixel. Click or drag: to a sample.");
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, packed(p.card), 5.0f * u);
    const int last = std::max(edge.count - 1, 1);
    const float inset = 12.0f * u;
    const auto x_of = [&](int sample) {
        return low.x + inset +
               (width - 2.0f * inset) * static_cast<float>(sample) / static_cast<float>(last);
    };
    const MicroscopeSummary& summary = edge.summary;
    const double largest =
        ui.microscope.shows_x ? summary.largest_drift_x : summary.largest_drift_y;
    const float middle = low.y + 0.5f * height;
    const auto y_of = [&](double drift) {
        const double share = largest != 0.0 ? drift / std::abs(largest) : 0.0;
        return middle - 0.32f * height * static_cast<float>(share);
    };
    list->AddLine({low.x + inset, middle}, {high.x - inset, middle}, packed(p.line));
    // At most two samples a screen pixel: more cannot be seen.
    const int stride = std::max(1, edge.count / std::max(1, static_cast<int>(2.0f * width)));
    ImVec2 before{x_of(0), y_of(0.0)};
    for (int i = 0; i < edge.count; i += stride) {
        const ImVec2 here{x_of(i), y_of(shown_coordinate(ui, edge.at(i)).drift)};
        list->AddLine(before, here, packed(p.link), 1.5f * u);
        before = here;
    }
    const ImU32 fail = packed(colour_of(Meaning::fail, ui.options.theme));
    float mark_before = -1e9f;
    for (const int i : edge.differing) {
        const float x = x_of(i);
        if (x - mark_before < 1.0f) continue;
        mark_before = x;
        list->AddTriangleFilled({x, high.y - 9.0f * u}, {x + 3.5f * u, high.y - 2.0f * u},
                                {x - 3.5f * u, high.y - 2.0f * u}, fail);
    }
    if (const int current = current_sample(ui); current >= 0) {
        list->AddLine({x_of(current), low.y + 2.0f * u}, {x_of(current), high.y - 2.0f * u},
                      packed(colour_of(Meaning::current, ui.options.theme)), 1.5f * u);
    }
    const std::string label = std::string("drift of ") + (ui.microscope.shows_x ? "x" : "y") +
                              (largest != 0.0 ? ", to " + drift_text(largest) : ": none");
    list->AddText(ui.fonts.small, ui.fonts.small->FontSize, {low.x + 8.0f * u, low.y + 3.0f * u},
                  packed(p.dim), label.c_str());
    if (is_held) {
        const float share =
            (ImGui::GetIO().MousePos.x - low.x - inset) / std::max(width - 2.0f * inset, 1.0f);
        const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(edge.count - 1);
        const int sample = static_cast<int>(at + 0.5f);
        if (sample != current_sample(ui)) go_to_sample(ui, sample);
    }
}

std::string coordinate_words(const char* axis, const char* pixel, const MicroscopeCoordinate& c) {
    std::string text =
        std::string(axis) + " = " + nine_digits(c.walked) + ", exactly " + fraction_text(c.exact);
    if (c.exact.denominator != 1) text += " = " + printed("%.12g", c.exact.value());
    text += "\n     " + std::string(pixel) + " " + whole_text(c.pixel);
    if (c.differs_from_exact()) text += ", where exact would be " + whole_text(c.exact_pixel);
    if (c.differs_from_reverse()) text += "; the other way: " + whole_text(c.reverse_pixel);
    return text;
}

/// A whole pixel; one that is not what it is compared with is marked.
void draw_pixel_cell(const Ui& ui, int pixel, bool differs, const ImVec4& quiet) {
    if (differs) {
        right_aligned("≠ " + whole_text(pixel), colour_of(Meaning::fail, ui.options.theme));
    } else {
        right_aligned(whole_text(pixel), quiet);
    }
}

void draw_sample(Ui& ui, int index, int current, int walked) {
    const Palette& p = palette(ui.options.theme);
    const MicroscopeSample sample = ui.microscope.shown.at(index);
    const MicroscopeCoordinate& c = shown_coordinate(ui, sample);
    const ImVec4& ink = index < walked ? p.text : p.dim;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(index);
    if (ImGui::Selectable("##sample", index == current,
                          ImGuiSelectableFlags_SpanAllColumns |
                              ImGuiSelectableFlags_AllowItemOverlap)) {
        go_to_sample(ui, index);
    }
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui.hovered_row = sample.y.pixel;
    const std::string tooltip = hovered ? "Sample " + std::to_string(index + 1) + "\n" +
                                              coordinate_words("x", "column", sample.x) + "\n" +
                                              coordinate_words("y", "row", sample.y) +
                                              "\nClick: to the moment in which it was entered."
                                        : std::string();
    name_widget(ui, "microscope.sample." + std::to_string(index), tooltip);
    ImGui::SameLine(0.0f, 0.0f);
    right_aligned(std::to_string(index + 1), ink);
    ImGui::PopID();
    ImGui::TableNextColumn();
    right_aligned(float_text(c.walked), ink);
    ImGui::TableNextColumn();
    right_aligned(mixed_text(c.exact), ink);
    ImGui::TableNextColumn();
    right_aligned(drift_text(c.drift), c.drift == 0.0 ? p.dim : ink);
    ImGui::TableNextColumn();
    draw_pixel_cell(ui, c.pixel, c.differs_from_exact(), ink);
    ImGui::TableNextColumn();
    draw_pixel_cell(ui, c.reverse_pixel, c.differs_from_reverse(), p.dim);
}

struct Column {
    const char* title;
    const char* help;
    int letters; ///< of its widest number
};

int digits(std::int64_t value) {
    return static_cast<int>(whole_text(std::abs(value)).size());
}

/// The columns for x or y of this edge, each as wide as its numbers may get.
std::array<Column, 6> columns_of(const Ui& ui) {
    const EdgeMicroscope& edge = ui.microscope.shown;
    const bool x = ui.microscope.shows_x;
    const int a = x ? edge.a.column : edge.a.row, b = x ? edge.b.column : edge.b.row;
    const std::int64_t denominator = (x ? edge.step_x : edge.step_y).denominator;
    const double drift = x ? edge.summary.largest_drift_x : edge.summary.largest_drift_y;
    const int sign = std::min(a, b) < 0 ? 1 : 0;
    const int whole = sign + digits(std::max(std::abs(a), std::abs(b)));
    const int fraction = denominator == 1 ? 0 : 2 + 2 * digits(denominator);
    const int exact = std::max(5, whole + fraction);
    return {{{"#", "Number of the sample along the edge, counted from 1.",
              std::max(2, digits(edge.count))},
             {x ? "x float" : "y float",
              "The value that the walk carries, in nine digits: enough to tell every float from "
              "its neighbours.",
              denominator == 1 ? std::max(whole, 7) : 11 + sign},
             {x ? "x exact" : "y exact",
              "Where the sample would be without any error: start + i (end - start) / steps, as a "
              "fraction in lowest terms.",
              exact},
             {"drift", "Float minus exact: what the additions have lost on the way here.",
              drift == 0.0 ? 4 : 9},
             {x ? "column" : "row",
              "The pixel that the float becomes. ≠: the exact place is on another pixel.",
              std::max(5, whole + 2)},
             {"reverse",
              "The pixel of this place when the edge is walked from its end to its start. ≠: "
              "another one than walking forwards.",
              std::max(5, whole + 2)}}};
}

void draw_headers(Ui& ui, const std::array<Column, 6>& columns) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i));
        ImGui::PushFont(ui.fonts.small);
        right_aligned(columns[i].title, palette(ui.options.theme).dim);
        ImGui::PopFont();
        name_widget(ui, "microscope.header." + std::to_string(i), columns[i].help);
    }
}

/// @param appears the panel was not on the screen before
void draw_table(Ui& ui, float height, bool appears) {
    const EdgeMicroscope& edge = ui.microscope.shown;
    const float u = ui.options.text_scale;
    const std::array<Column, 6> columns = columns_of(ui);
    ImGui::PushFont(ui.fonts.mono);
    const float letter = ImGui::CalcTextSize("0").x;
    ImGui::PopFont();
    const ImVec2 padding{4.0f * u, ImGui::GetStyle().CellPadding.y};
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, padding);
    float needed = ImGui::GetStyle().ScrollbarSize;
    for (const Column& column : columns)
        needed += letter * static_cast<float>(column.letters) + 2.0f * padding.x;
    const bool fits = needed <= ImGui::GetContentRegionAvail().x;
    const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH |
                                  ImGuiTableFlags_PadOuterX |
                                  (fits ? ImGuiTableFlags_SizingStretchProp
                                        : ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit);
    // Two tables, because ImGui remembers the widths of each.
    const char* const id = fits ? "samples" : "samples that scroll";
    if (!ImGui::BeginTable(id, static_cast<int>(columns.size()), flags, {0, height})) {
        ImGui::PopStyleVar();
        return;
    }
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : columns) {
        const float width = letter * static_cast<float>(column.letters);
        ImGui::TableSetupColumn(
            "", fits ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed,
            width);
    }
    draw_headers(ui, columns);
    ImGui::PushFont(ui.fonts.mono);
    const int current = current_sample(ui), walked = samples_walked(ui);
    ImGuiListClipper clipper;
    clipper.Begin(edge.count);
    const bool follows = (ui.follow_cursor || appears) && current >= 0 && current < edge.count;
    if (follows) clipper.ForceDisplayRangeByIndices(current, current + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            draw_sample(ui, i, current, walked);
            if (follows && i == current && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
        }
    }
    ImGui::PopFont();
    ImGui::EndTable();
    ImGui::PopStyleVar();
}

} // namespace

void draw_microscope_panel(Ui& ui) {
    ui.hovered_row = std::nullopt;
    const Palette& p = palette(ui.options.theme);
    if (!ui.results.triangle) {
        text_in(p.dim, "The scene has no triangles.");
        return;
    }
    draw_triangle_title(ui);
    if (!ui.results.frame.is_drawn(*ui.results.triangle)) {
        wrapped_text("This triangle is left out, so it has no edges. The Vertices tab says why.");
        return;
    }
    const bool appears = ImGui::IsWindowAppearing();
    look_at_edge(ui);
    draw_buttons(ui);
    const float line = ui.fonts.mono->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y;
    const float needed = static_cast<float>(ui.microscope.shown.count + 2) * line;
    const float u = ui.options.text_scale;
    const float room = ImGui::GetContentRegionAvail().y;
    const auto table_height = [&](int fewest_lines) {
        const float fewest = static_cast<float>(fewest_lines) * line;
        return std::max(std::min(needed, ImGui::GetContentRegionAvail().y), fewest);
    };
    if (room >= 400.0f * u) {
        draw_summary(ui);
        draw_drift_curve(ui);
        draw_table(ui, table_height(7), appears);
        return;
    }
    // Where there is little room the numbers come first, and the words below them.
    if (room >= 220.0f * u) {
        ImGui::PushTextWrapPos(0.0f);
        draw_verdict(ui);
        ImGui::PopTextWrapPos();
    }
    draw_table(ui, table_height(4), appears);
    draw_drift_curve(ui);
    draw_summary(ui);
}

} // namespace rasterwalk
