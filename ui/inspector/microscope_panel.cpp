#include <algorithm>
#include <string>
#include <utility>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/line_rules.h"
#include "session/walk.h"
#include "ui/inspector/microscope_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

std::string place_text(int column, int row) {
    return "(" + whole_text(column) + "," + whole_text(row) + ")";
}

/// "3 of 11 samples"
std::string some_samples(std::size_t count, int of) {
    return std::to_string(count) + " of " + counted(of, "sample", "samples");
}

/// At this height of the page below the buttons, summary and curve leave the table plenty of lines;
/// design pixels.
constexpr float roomy_page = 480.0f;

/// The picked edge, until the cursor reaches another one.
void look_at_edge(Ui& ui) {
    MicroscopeView& view = ui.inspector.microscope;
    const std::optional<Cursor>& done = ui.results.a.done;
    if (view.picked_at != ui.results.a.cursor && done && done->phase == Phase::edges &&
        done->triangle == *ui.results.a.triangle) {
        view.edge = done->index;
    }
    const Frame& frame = ui.results.a.frame;
    const int triangle = *ui.results.a.triangle;
    const auto edges = static_cast<int>(frame.triangle_vertices(triangle).size());
    view.edge = std::min(view.edge, edges - 1);
    look_at(view.shown, frame, triangle, view.edge);
    const std::pair<int, int> edge{triangle, view.edge};
    if (view.axis_chosen_for == edge) return;
    // One of the two moves by whole pixels and never drifts: the other one is interesting. A line
    // walk that decides moves straight along its longer axis: the other coordinate is decided.
    const MicroscopeSummary& summary = view.shown.summary;
    view.shows_x = view.shown.decides()
                       ? view.shown.frame.is_steep
                       : summary.largest_drift_y == 0.0 && summary.largest_drift_x != 0.0;
    view.axis_chosen_for = edge;
}

/// Chooses which of a sample's two numbers is shown: each button says what its number decides, and
/// if nothing was lost in one, that is said next to it.
void draw_axis_choice(Ui& ui, float gap) {
    MicroscopeView& view = ui.inspector.microscope;
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const char* const caption = "value";
    // Where lines are few all buttons share one; the tooltips say the rest.
    const bool is_low = ui.inspector.is_low;
    const std::string x = is_low ? "x" : "x → column", y = is_low ? "y" : "y → row";
    // The words and the two buttons stay together.
    const float between = 6.0f * u;
    const float width = (is_low ? 0.0f : ImGui::CalcTextSize(caption).x + between) +
                        button_width(x) + button_width(y) + between;
    const float right = right_end();
    if (ImGui::GetItemRectMax().x + gap + width <= right) ImGui::SameLine(0.0f, gap);
    if (!is_low) {
        ImGui::AlignTextToFramePadding();
        text_in(p.dim, caption);
        register_widget(ui, "microscope.axis",
                        "Each sample has an x and a y, and each has its own step. Table and curve "
                        "below show one of the two.");
        ImGui::SameLine(0.0f, between);
    }
    if (button(ui, "microscope.x", x, view.shows_x ? Look::chosen : Look::plain,
               "Shows x, which decides the column of a sample.")) {
        view.shows_x = true;
    }
    same_line_if_room(y, between);
    if (button(ui, "microscope.y", y, view.shows_x ? Look::plain : Look::chosen,
               "Shows y, which decides the row of a sample.")) {
        view.shows_x = false;
    }
    const MicroscopeSummary& summary = view.shown.summary;
    const bool x_drifts = summary.largest_drift_x != 0.0, y_drifts = summary.largest_drift_y != 0.0;
    if (x_drifts == y_drifts || is_low || view.shown.decides()) return;
    const char* const note = x_drifts ? "only x drifts" : "only y drifts";
    const float room = right - ImGui::GetItemRectMax().x - 2.0f * between;
    if (ImGui::CalcTextSize(note).x > room) return;
    ImGui::SameLine(0.0f, 2.0f * between);
    text_in(p.dim, note);
}

void draw_buttons(Ui& ui) {
    MicroscopeView& view = ui.inspector.microscope;
    const float u = ui.options.text_scale;
    // In a narrow column the tooltips have to say what the signs mean.
    const bool is_narrow = ImGui::GetContentRegionAvail().x < 340.0f * u;
    const float gap = is_narrow ? 8.0f * u : 18.0f * u;
    const auto edges =
        static_cast<int>(ui.results.a.frame.triangle_vertices(*ui.results.a.triangle).size());
    for (int e = 0; e < edges; ++e) {
        const std::string label = is_narrow ? "e" + std::to_string(e) : edge_name(e);
        if (e > 0) same_line_if_room(label, 6.0f * u);
        if (button(ui, "microscope.edge." + std::to_string(e), label,
                   e == view.edge ? Look::chosen : Look::plain,
                   "Puts " + edge_name(e) + " of the triangle under the microscope.")) {
            view.edge = e;
            view.picked_at = ui.results.a.cursor;
        }
    }
    draw_axis_choice(ui, gap);
    if (view.shown.differing.empty()) return;
    const char* const next_label = is_narrow ? "≠" : "next ≠";
    same_line_if_room(next_label, gap);
    if (button(
            ui, "microscope.next", next_label, Look::plain,
            "Goes to the next sample that falls on a different pixel from its exact position.")) {
        const int current = current_sample(ui);
        const int next = view.shown.next_difference(current + 1);
        const MicroscopeSample sample = view.shown.at(next);
        view.shows_x = !sample.y.differs_from_exact();
        go_to_sample(ui, next);
    }
}

/// A line of the card: quiet if all is well, marked if not.
void draw_statement(Ui& ui, bool in_order, const std::string& text) {
    const Palette& p = palette(ui.options.theme);
    text_in(in_order ? p.dim : colour_of(Meaning::fail, ui.options.theme),
            (in_order ? "=  " : "≠  ") + text);
}

void draw_step(Ui& ui, const char* axis, const Fraction& step, float float_step, double drift) {
    const bool is_exact = static_cast<double>(float_step) * static_cast<double>(step.denominator) ==
                          static_cast<double>(step.numerator);
    std::string text = std::string(axis) + ": step " + fraction_text(step);
    text += is_exact ? ", exact in float" : ", in float " + nine_digits_shown(float_step);
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
void draw_verdict(Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const std::size_t differing = edge.differing.size();
    draw_statement(ui, differing == 0,
                   differing == 0 ? (edge.decides() ? "every sample is on a nearest pixel"
                                                    : "every sample is on its exact pixel")
                                  : some_samples(differing, edge.count) +
                                        (edge.decides() ? " not on a nearest pixel"
                                                        : " not on the exact pixel"));
}

const char* walk_text(LineWalk walk) {
    switch (walk) {
    case LineWalk::accumulate:
    case LineWalk::zinv_falls: // along rows
        return "each sample adds the step to the previous one, in float";
    case LineWalk::multiply:
        return "sample i is the start plus i times the step, in float";
    case LineWalk::integer_step:
        return "each sample adds the step to the previous one; the step is divided as int by int";
    case LineWalk::short_step:
        return "each sample adds the step to the previous one; the step is divided by the number "
               "of samples, which is one too many";
    case LineWalk::exact:
        return "pixels come from exact fractions; the floats are only shown";
    }
    return "";
}

/// The decision at the last sample entered, with its numbers; false: there is none.
bool draw_current_decision(Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const int current = current_sample(ui);
    if (!edge.decides() || current < 0 || current >= edge.count) return false;
    const LineAlgorithm line = ui.results.a.frame.settings.line;
    text_in(colour_of(Meaning::current, ui.options.theme),
            "line[" + std::to_string(current) +
                "]: " + with_minus_signs(decision_words(edge, line, current)));
    return true;
}

/// How the samples of the edge are found.
void draw_sampling(Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const Settings& settings = ui.results.a.frame.settings;
    const Palette& p = palette(ui.options.theme);
    if (!edge.decides()) {
        text_in(p.dim, walk_text(settings.line_walk));
        draw_step(ui, "x", edge.step_x, edge.float_step_x, edge.summary.largest_drift_x);
        draw_step(ui, "y", edge.step_y, edge.float_step_y, edge.summary.largest_drift_y);
        return;
    }
    text_in(p.dim, line_summary(settings.line, settings.bresenham_rule));
    for (const std::string& rule : line_rules(edge, settings.line, settings.bresenham_rule))
        text_in(p.text, with_minus_signs(rule));
    draw_current_decision(ui);
}

/// What this edge shows, in words.
void draw_summary(Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const MicroscopeSummary& summary = edge.summary;
    begin_card(ui);
    text_in(colour_of(edge_meaning(ui.inspector.microscope.edge), ui.options.theme),
            edge_name(ui.inspector.microscope.edge));
    ImGui::SameLine(0.0f, 0.0f);
    put_text(" from " + place_text(edge.a.column, edge.a.row) + " to " +
             place_text(edge.b.column, edge.b.row));
    draw_sampling(ui);
    draw_verdict(ui);
    if (summary.misses_end) {
        const EdgeMicroscope::Place& last = edge.forward.back();
        draw_statement(ui, false,
                       "the last is on " + place_text(last.column, last.row) +
                           " and misses the end point");
    }
    const int reverse = summary.differ_from_reverse;
    draw_statement(ui, reverse == 0,
                   reverse == 0 ? "the same pixels when walked backward"
                                : "walked backward: " +
                                      some_samples(static_cast<std::size_t>(reverse), edge.count) +
                                      " on another pixel");
    end_card(ui);
}

} // namespace

int current_sample(const Ui& ui) {
    const std::optional<Cursor>& done = ui.results.a.done;
    const bool is_here = done && done->triangle == *ui.results.a.triangle &&
                         done->phase == Phase::edges && done->index == ui.inspector.microscope.edge;
    return is_here ? done->step : -1;
}

void go_to_sample(Ui& ui, int sample) {
    const Timeline timeline(ui.results.a.frame);
    const Cursor cursor{*ui.results.a.triangle, Phase::edges, ui.inspector.microscope.edge, sample};
    if (timeline.exists(cursor))
        go_to(ui.session, timeline, timeline.next(cursor, Granularity::moment));
}

const MicroscopeCoordinate& shown_coordinate(const Ui& ui, const MicroscopeSample& sample) {
    return ui.inspector.microscope.shows_x ? sample.x : sample.y;
}

void draw_microscope_panel(Ui& ui) {
    if (!begin_triangle_panel(ui, "edges")) return;
    const bool appears = ImGui::IsWindowAppearing();
    look_at_edge(ui);
    draw_buttons(ui);
    const float u = ui.options.text_scale;
    const float room = ImGui::GetContentRegionAvail().y;
    if (room >= roomy_page * u && !ui.inspector.is_narrow) {
        draw_summary(ui);
        draw_drift_curve(ui);
        const float line = ui.fonts.mono->FontSize + 2.0f * ImGui::GetStyle().CellPadding.y;
        const float needed = static_cast<float>(ui.inspector.microscope.shown.count + 2) * line;
        draw_sample_table(ui, std::min(needed, ImGui::GetContentRegionAvail().y), appears);
        return;
    }
    // If there is little room the numbers come first, and the words below them.
    if (room >= 220.0f * u) {
        ImGui::PushTextWrapPos(0.0f);
        if (!draw_current_decision(ui)) draw_verdict(ui);
        ImGui::PopTextWrapPos();
    }
    draw_sample_table_with(ui, appears, [&] {
        draw_drift_curve(ui);
        draw_summary(ui);
    });
}

} // namespace rasterwalk
