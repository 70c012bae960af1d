#include "ui/canvas/decision_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/numbers.h"
#include "explain/line_rules.h"
#include "ui/canvas/marks.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Of the graph across the line, design pixels: the signs of the steps, and around it.
constexpr float steps_room = 14.0f, graph_margin = 3.0f;

/// The room for the values, design pixels: in a roomy picture, and at least.
constexpr std::array<float, 2> values_rooms{44.0f, 22.0f};

/// Before the first cell along the line, for the name of d, design pixels.
constexpr float name_room = 16.0f;

/// Under the graph, whatever lies there.
constexpr ImU32 graph_ground = IM_COL32(12, 13, 16, 235);

/// The coordinate along the line, and the one across it.
float along(const DecisionGraph& graph, ImVec2 p) {
    return graph.is_steep ? p.y : p.x;
}
float across(const DecisionGraph& graph, ImVec2 p) {
    return graph.is_steep ? p.x : p.y;
}
ImVec2 point(const DecisionGraph& graph, float along, float across) {
    return graph.is_steep ? ImVec2(across, along) : ImVec2(along, across);
}

std::string number_of(const DecisionMark& mark) {
    return with_minus_signs(decision_number(mark.before));
}

/// The room for the numbers of all marks; 0 if one does not fit in its cell.
float numbers_room(const Ui& ui, const DecisionGraph& graph) {
    const ImFont* const font = ui.fonts.mono_small;
    float widest = 0.0f;
    for (const double value : {graph.least, graph.most})
        widest = std::max(widest, text_width(font, with_minus_signs(decision_number(value))));
    const float margin = 2.0f * ui.options.text_scale;
    const float cell = ui.canvas.place.scale;
    const float along_room = graph.is_steep ? font->FontSize : widest;
    if (along_room + margin > cell) return 0.0f;
    return (graph.is_steep ? widest : font->FontSize) + margin;
}

float thickness(const Ui& ui, const DecisionGraph& graph, float values) {
    return (steps_room + 2.0f * graph_margin) * ui.options.text_scale + values +
           numbers_room(ui, graph);
}

/// The triangle's middle, on the screen.
ImVec2 middle_of_triangle(const Ui& ui) {
    const PolygonCorners vertices = ui.results.a.frame.triangle_vertices(*ui.results.a.triangle);
    ImVec2 sum{0, 0};
    for (const ScreenVertex& v : vertices) {
        const ImVec2 at = ui.canvas.place.middle_of({v.column, v.row});
        sum = {sum.x + at.x, sum.y + at.y};
    }
    const auto count = static_cast<float>(vertices.size());
    return {sum.x / count, sum.y / count};
}

/// How many samples of an edge are entered at the cursor.
int entered_samples_of(const RowHistory& history, int edge) {
    if (!history.last || edge > history.last->edge) return 0;
    if (edge == history.last->edge) return history.last->sample + 1;
    return history.edge_samples[static_cast<std::size_t>(edge)];
}

/// The edge whose decisions are of use now.
std::optional<int> edge_in_work(const Ui& ui) {
    const RunResults& a = ui.results.a;
    if (tab_below(ui.session) == "microscope") return ui.inspector.microscope.edge;
    const bool is_at_work = a.done && a.cursor != cursor_end && a.done->phase == Phase::edges &&
                            a.done->triangle == a.triangle;
    return is_at_work ? std::optional(a.done->index) : std::nullopt;
}

/// A short line in the direction of a step.
void draw_step(ImDrawList* list, ImVec2 middle, glm::ivec2 step, float length, float width) {
    if (step == glm::ivec2(0)) return;
    const ImVec2 half{0.5f * length * static_cast<float>(step.x),
                      0.5f * length * static_cast<float>(step.y)};
    const ImVec2 tip{middle.x + half.x, middle.y + half.y};
    const ImU32 colour = packed(palette(Theme::dark).text);
    list->AddLine({middle.x - half.x, middle.y - half.y}, tip, colour, width);
    list->AddCircleFilled(tip, 1.6f * width, colour);
}

} // namespace

std::optional<DecisionGraph> shown_decisions(Ui& ui) {
    const RunResults& a = ui.results.a;
    const bool is_old = a.preview.is_shown && a.is_frame_late;
    if (is_old || !a.triangle || !a.frame.is_drawn(*a.triangle) ||
        ui.canvas.place.scale < cell_zoom || a.rows.sample_count == 0) {
        return std::nullopt;
    }
    const std::optional<int> edge = edge_in_work(ui);
    const auto edges = static_cast<int>(a.frame.triangle_vertices(*a.triangle).size());
    if (!edge || *edge >= edges) return std::nullopt;
    EdgeMicroscope& shown = ui.inspector.microscope.shown;
    look_at(shown, a.frame, *a.triangle, *edge);
    DecisionGraph graph = decision_graph(shown, entered_samples_of(a.rows, *edge));
    return graph.marks.empty() ? std::nullopt : std::optional(std::move(graph));
}

std::optional<DecisionBand> place_decisions(const Ui& ui, const DecisionGraph& graph,
                                            const Pane& visible,
                                            const std::vector<CanvasLabel>& labels) {
    const PicturePlace& place = ui.canvas.place;
    const float half = 0.5f * place.scale, gap = 3.0f * ui.options.text_scale;
    const auto is_seen = [&](const DecisionMark& mark) {
        const ImVec2 at = place.middle_of(mark.pixel);
        return at.x - half >= visible.low.x && at.x + half <= visible.high.x &&
               at.y - half >= visible.low.y && at.y + half <= visible.high.y;
    };
    const auto begin = std::find_if(graph.marks.begin(), graph.marks.end(), is_seen);
    const auto end = std::find_if_not(begin, graph.marks.end(), is_seen);
    if (begin == end) return std::nullopt;
    const auto [least, most] =
        std::minmax_element(begin, end, [&](const DecisionMark& a, const DecisionMark& b) {
            return across(graph, place.middle_of(a.pixel)) <
                   across(graph, place.middle_of(b.pixel));
        });
    const float a = along(graph, place.middle_of(begin->pixel));
    const float b = along(graph, place.middle_of((end - 1)->pixel));
    const float from = std::min(a, b) - half - name_room * ui.options.text_scale;
    const float to = std::max(a, b) + half;
    const float high_side = across(graph, place.middle_of(most->pixel)) + half + gap;
    const float low_side = across(graph, place.middle_of(least->pixel)) - half - gap;
    const bool is_below = across(graph, middle_of_triangle(ui)) < 0.5f * (high_side + low_side);
    const auto in_room = [&](bool is_after, float values) -> std::optional<DecisionBand> {
        const float size = thickness(ui, graph, values);
        const float start = is_after ? high_side : low_side - size;
        const ImVec2 low = point(graph, from, start), high = point(graph, to, start + size);
        const bool has_room = low.x >= visible.low.x && low.y >= visible.low.y &&
                              high.x <= visible.high.x && high.y <= visible.high.y;
        if (!has_room || is_under_label(low, high, labels)) return std::nullopt;
        return DecisionBand{low, high, values,
                            static_cast<std::size_t>(begin - graph.marks.begin()),
                            static_cast<std::size_t>(end - graph.marks.begin())};
    };
    for (const float values : values_rooms) {
        for (const bool is_after : {is_below, !is_below}) {
            if (const auto band = in_room(is_after, values * ui.options.text_scale)) return band;
        }
    }
    return std::nullopt;
}

void draw_decisions(Ui& ui, ImDrawList* list, const Pane& visible,
                    const std::vector<CanvasLabel>& labels) {
    const std::optional<DecisionGraph> graph = shown_decisions(ui);
    if (!graph) return;
    const std::optional<DecisionBand> band = place_decisions(ui, *graph, visible, labels);
    if (!band) return;
    const float u = ui.options.text_scale, scale = ui.canvas.place.scale;
    const float start = across(*graph, band->low);
    const float steps_at = start + (graph_margin + 0.5f * steps_room) * u;
    const float values_low = start + (graph_margin + steps_room) * u;
    const double range = std::max(graph->most - graph->least, 1.0);
    const auto place_of = [&](double value) {
        // Up is more, and to the right.
        const double share =
            graph->is_steep ? (value - graph->least) / range : (graph->most - value) / range;
        return values_low + 3.0f * u + (band->values - 6.0f * u) * static_cast<float>(share);
    };
    const float zero = place_of(0.0);
    const bool has_numbers = numbers_room(ui, *graph) > 0.0f;
    ImFont* const font = ui.fonts.mono_small;
    list->AddRectFilled(band->low, band->high, graph_ground, 3.0f * u);
    list->AddLine(point(*graph, along(*graph, band->low) + name_room * u, zero),
                  point(*graph, along(*graph, band->high), zero), packed(palette(Theme::dark).dim),
                  u);
    const ImU32 colour = packed(colour_of(Meaning::current, Theme::dark));
    const ImVec2 name = point(*graph, along(*graph, band->low) + 0.5f * name_room * u, zero);
    list->AddText(font, font->FontSize,
                  {std::round(name.x - 0.5f * text_width(font, "d")),
                   std::round(name.y - 0.5f * font->FontSize)},
                  colour, "d");
    for (std::size_t i = band->first; i < band->behind; ++i) {
        const DecisionMark& mark = graph->marks[i];
        const float at = along(*graph, ui.canvas.place.middle_of(mark.pixel));
        const float value = place_of(mark.before);
        list->AddLine(point(*graph, at, zero), point(*graph, at, value), colour, 2.0f * u);
        list->AddCircleFilled(point(*graph, at, value), 3.0f * u, colour);
        draw_step(list, point(*graph, at, steps_at), mark.step, std::min(0.35f * scale, 9.0f * u),
                  1.4f * u);
        if (!has_numbers) continue;
        const std::string text = number_of(mark);
        const float width = text_width(font, text), end = values_low + band->values;
        const ImVec2 low = graph->is_steep ? ImVec2(end, at - 0.5f * font->FontSize)
                                           : ImVec2(at - 0.5f * width, end);
        list->AddText(font, font->FontSize, {std::round(low.x), std::round(low.y)}, colour,
                      text.c_str());
    }
}

} // namespace rasterwalk
