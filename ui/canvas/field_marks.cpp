#include "ui/canvas/field_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "base/element_names.h"
#include "base/numbers.h"
#include "picture/overlay.h"
#include "ui/canvas/marks.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// From one line of equal E to the next, at least, design pixels.
constexpr float line_distance = 60.0f;

/// Where the line of the edge is named, a share of its length.
constexpr float edge_name_share = 0.12f;

/// How strongly a triangle of the picked pixel is tinted, 0..1.
constexpr float part_tint = 0.45f;

/// What is written on the picture: each text in a box, and no box over another.
struct Labels {
    const Ui& ui;
    ImDrawList* list;
    ImVec2 low, high;               ///< of the visible part of the canvas
    std::vector<CanvasLabel> taken; ///< those of the vertices first

    /// Writes a text with its middle there, if there is room.
    void add(ImVec2 middle, const std::string& text, ImU32 colour) {
        ImFont* const font = ui.fonts.mono_small;
        const float u = ui.options.text_scale;
        const ImVec2 half{0.5f * text_width(font, text) + 3.0f * u, 0.5f * font->FontSize + u};
        const ImVec2 from{std::round(middle.x - half.x), std::round(middle.y - half.y)};
        const ImVec2 to{from.x + 2.0f * half.x, from.y + 2.0f * half.y};
        const bool is_cut = from.x < low.x || from.y < low.y || to.x > high.x || to.y > high.y;
        if (is_cut || is_under_label(from, to, taken)) return;
        const ImVec2 letters{from.x + 3.0f * u, from.y + u};
        taken.push_back({text, from, to, letters});
        list->AddRectFilled(from, to, dark_casing, 3.0f * u);
        list->AddText(font, font->FontSize, letters, colour, text.c_str());
    }
};

/// A place in the picture, pixels from its upper left corner, on the screen.
ImVec2 screen_place(const PicturePlace& place, const glm::dvec2& p) {
    return {place.origin.x + place.scale * static_cast<float>(p.x),
            place.origin.y + place.scale * static_cast<float>(p.y)};
}

ImVec2 screen_place(const PicturePlace& place, const GridPoint& p) {
    constexpr double parts = grid_parts;
    return screen_place(
        place, glm::dvec2(static_cast<double>(p.x) / parts, static_cast<double>(p.y) / parts));
}

/// The farthest point from `from` toward `to` that lies between `low` and `high`; `from` if that
/// lies outside itself.
ImVec2 seen_toward(ImVec2 from, ImVec2 to, ImVec2 low, ImVec2 high) {
    float share = 1.0f;
    const auto limit = [&](float start, float end, float least, float most) {
        if (end > most) share = std::min(share, (most - start) / (end - start));
        if (end < least) share = std::min(share, (least - start) / (end - start));
    };
    limit(from.x, to.x, low.x, high.x);
    limit(from.y, to.y, low.y, high.y);
    share = std::max(share, 0.0f);
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

ImU32 colour_of_part(const WeightPart& part, float opacity = 1.0f) {
    const Meaning meaning = part.edge < 0 ? Meaning::current : edge_meaning(part.edge);
    return packed(colour_of(meaning, Theme::dark), opacity);
}

/// The lines of the field in a part of the canvas.
std::vector<FieldLine> seen_lines(const Ui& ui, const Pane& pane) {
    const std::optional<EdgeField>& field = ui.results.overlay.field;
    if (!field) return {};
    const PicturePlace& place = ui.canvas.place;
    const Viewport size = ui.results.a.frame.settings.viewport;
    const ImVec2 from = picture_point(place, pane.low), to = picture_point(place, pane.high);
    const double step = field_step(
        *field, static_cast<double>(line_distance * ui.options.text_scale / place.scale));
    return field_lines(*field, glm::max(glm::dvec2(from.x, from.y), glm::dvec2(0.0)),
                       glm::min(glm::dvec2(to.x, to.y), glm::dvec2(size.width, size.height)), step);
}

void add_weights(const Ui& ui, Labels& labels) {
    const std::optional<WeightParts>& weights = ui.results.overlay.weights;
    if (!weights) return;
    const PicturePlace& place = ui.canvas.place;
    const float u = ui.options.text_scale;
    const ImVec2 centre = screen_place(place, weights->centre);
    const ImFont* const font = ui.fonts.mono_small;
    const ImVec2 half{0.5f * text_width(font, "−0.000") + 4.0f * u,
                      0.5f * font->FontSize + 2.0f * u};
    for (const WeightPart& part : weights->parts) {
        const ImVec2 a = screen_place(place, part.from), b = screen_place(place, part.to);
        const ImVec2 middle{(a.x + b.x + centre.x) / 3.0f, (a.y + b.y + centre.y) / 3.0f};
        labels.add(seen_toward(centre, middle, {labels.low.x + half.x, labels.low.y + half.y},
                               {labels.high.x - half.x, labels.high.y - half.y}),
                   with_minus_signs(decimals(static_cast<double>(part.weight), 3)),
                   colour_of_part(part));
    }
}

void add_field_values(const Ui& ui, Labels& labels) {
    const std::vector<FieldLine> lines = seen_lines(ui, {labels.low, labels.high});
    // The edge's own line is named first, near its end: the triangle is at its middle.
    for (const bool is_edge : {true, false}) {
        for (const FieldLine& line : lines) {
            if ((line.e == 0.0) != is_edge) continue;
            const ImVec2 a = screen_place(ui.canvas.place, line.from),
                         b = screen_place(ui.canvas.place, line.to);
            const float share = is_edge ? edge_name_share : 0.5f;
            const Meaning meaning = is_edge        ? Meaning::current
                                    : line.e > 0.0 ? Meaning::pass
                                                   : Meaning::fail;
            labels.add({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)},
                       is_edge ? "E = 0" : with_minus_signs(decimals(line.e, 0)),
                       packed(colour_of(meaning, Theme::dark)));
        }
    }
}

} // namespace

void draw_field_lines(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high) {
    const float u = ui.options.text_scale;
    for (const FieldLine& line : seen_lines(ui, {low, high})) {
        const ImVec2 a = screen_place(ui.canvas.place, line.from),
                     b = screen_place(ui.canvas.place, line.to);
        const bool is_edge = line.e == 0.0;
        if (is_edge) list->AddLine(a, b, dark_casing, 3.6f * u);
        list->AddLine(a, b, IM_COL32(255, 255, 255, is_edge ? 255 : 110),
                      (is_edge ? 1.8f : 1.0f) * u);
    }
}

void draw_weight_parts(const Ui& ui, ImDrawList* list) {
    const std::optional<WeightParts>& weights = ui.results.overlay.weights;
    if (!weights) return;
    const PicturePlace& place = ui.canvas.place;
    const float u = ui.options.text_scale;
    const ImVec2 centre = screen_place(place, weights->centre);
    for (const WeightPart& part : weights->parts) {
        const ImVec2 a = screen_place(place, part.from), b = screen_place(place, part.to);
        if (part.weight < 0.0f) {
            list->AddTriangle(a, b, centre, dark_casing, 3.6f * u);
            list->AddTriangle(a, b, centre, colour_of_part(part), 1.6f * u);
        } else {
            list->AddTriangleFilled(a, b, centre, colour_of_part(part, part_tint));
            list->AddTriangle(a, b, centre, colour_of_part(part), 1.2f * u);
        }
    }
}

void draw_figure_numbers(const Ui& ui, ImDrawList* list, const Pane& visible,
                         const std::vector<CanvasLabel>& vertices) {
    if (ui.results.a.preview.is_shown) return; // as the overlays
    Labels labels{ui, list, visible.low, visible.high, vertices};
    add_weights(ui, labels);
    add_field_values(ui, labels);
}

void draw_weights_swatch(ImDrawList* list, ImVec2 at, ImVec2 size) {
    const ImVec2 top{at.x + 0.5f * size.x, at.y}, middle{top.x, at.y + 0.6f * size.y};
    const ImVec2 left{at.x, at.y + size.y}, right{at.x + size.x, at.y + size.y};
    const auto part = [&](ImVec2 a, ImVec2 b, int edge) {
        const ImVec4 colour = colour_of(edge_meaning(edge), Theme::dark);
        list->AddTriangleFilled(a, b, middle, packed(colour));
    };
    part(left, top, 0);
    part(top, right, 1);
    part(right, left, 2);
}

float draw_field_choice(Ui& ui, ImVec2 at, float height) {
    const std::optional<EdgeField>& field = ui.results.overlay.field;
    if (!field) return at.x;
    const float u = ui.options.text_scale;
    const auto edges =
        static_cast<int>(ui.results.a.frame.triangle_vertices(field->triangle).size());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    float x = at.x;
    for (int edge = 0; edge < edges; ++edge) {
        ImGui::SetCursorScreenPos({x, at.y});
        std::optional<int>& chosen = ui.session.canvas.field_edge;
        const std::string number = std::to_string(edge);
        if (button(ui, "legend.edge." + number, number,
                   field->edge.number == edge ? Look::chosen : Look::quiet,
                   "Shows the field of " + edge_name(edge) +
                       (chosen == edge ? ".\nClick again to follow the edge at work." : "."),
                   {1.6f * height, height}))
            chosen = chosen == edge ? std::nullopt : std::optional(edge);
        x += 1.6f * height + 2.0f * u;
    }
    ImGui::PopStyleVar();
    return x;
}

} // namespace rasterwalk
