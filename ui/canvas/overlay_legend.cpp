#include "ui/canvas/overlay_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "picture/colour_map.h"
#include "picture/overlay.h"
#include "ui/canvas/cost_legend.h"
#include "ui/canvas/field_marks.h"
#include "ui/canvas/picture_view.h"
#include "ui/canvas/vector_legend.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Cells of a swatch: picture pixels, slightly enlarged.
constexpr int swatch_columns = 12;
constexpr int swatch_rows = 6;
constexpr float swatch_cell = 2.0f; ///< design pixels

/// The canvas below its header must have this height for a legend, design pixels.
constexpr float least_room = 130.0f;

/// A grey between the darkest and the brightest pictures, on which all tints can be seen.
constexpr ImU32 swatch_ground = IM_COL32(78, 80, 84, 255);

ImU32 packed_tint(const Tint& tint) {
    return IM_COL32(tint.colour.r, tint.colour.g, tint.colour.b,
                    static_cast<int>(std::lround(255.0f * tint.opacity)));
}

/// Does the overlay show an amount, by a scale of colours?
bool is_scale(Overlay overlay) {
    return overlay == Overlay::overdraw || overlay == Overlay::affine_error ||
           overlay == Overlay::cost || overlay == Overlay::edge_field ||
           overlay == Overlay::mip_level;
}

/// How much of the overlay a place in its swatch shows, from 0 at the left to 1 at the right.
float swatch_amount(Overlay overlay, float share) {
    if (overlay == Overlay::depth) return share < 0.5f ? 1.0f : 0.0f;
    return is_scale(overlay) ? share : 1.0f;
}

} // namespace

ImVec2 swatch_size(const Ui& ui) {
    const float cell = swatch_cell * ui.options.text_scale;
    return {std::round(swatch_columns * cell), std::round(swatch_rows * cell)};
}

void draw_swatch(const Ui& ui, ImDrawList* list, ImVec2 at, Overlay overlay, float from, float to) {
    const ImVec2 size = swatch_size(ui);
    const float cell = size.x / swatch_columns;
    list->AddRectFilled(at, {at.x + size.x, at.y + size.y}, swatch_ground);
    if (overlay == Overlay::wireframe) {
        const ImU32 white = IM_COL32(255, 255, 255, 235);
        const float m = 0.15f * size.y;
        list->AddTriangle({at.x + m, at.y + size.y - m}, {at.x + 0.55f * size.x, at.y + m},
                          {at.x + size.x - m, at.y + size.y - m}, white,
                          std::max(1.0f, ui.options.text_scale));
        return;
    }
    if (overlay == Overlay::vectors) return draw_vector_swatch(ui, list, at, size);
    if (overlay == Overlay::alone) {
        const ImU32 white = IM_COL32(255, 255, 255, 235);
        const float m = 0.15f * size.y, low = at.y + size.y - m;
        const ImVec2 top{at.x + 0.55f * size.x, at.y + m}, foot{at.x + 0.45f * size.x, low};
        list->AddTriangleFilled({at.x + m, low}, top, foot, white);
        list->AddTriangle(foot, top, {at.x + size.x - m, low}, white,
                          std::max(1.0f, ui.options.text_scale));
        return;
    }
    if (overlay == Overlay::weights) {
        draw_weights_swatch(list, at, size);
        return;
    }
    for (int row = 0; row < swatch_rows; ++row) {
        for (int column = 0; column < swatch_columns; ++column) {
            const float share =
                from + (to - from) * static_cast<float>(column) / (swatch_columns - 1);
            const Tint tint =
                overlay_tint(overlay, swatch_amount(overlay, share), {column, row}, column / 4);
            const ImVec2 corner{at.x + cell * static_cast<float>(column),
                                at.y + cell * static_cast<float>(row)};
            list->AddRectFilled(corner, {corner.x + cell, corner.y + cell}, packed_tint(tint));
        }
    }
}

namespace {

std::string value_at(const Ui& ui, Overlay overlay, glm::ivec2 pixel) {
    // As near as the eye can judge, however much the picture is enlarged.
    const float reach = std::max(5.0f * ui.options.text_scale / ui.canvas.place.scale, 0.75f);
    return overlay_value(overlay, ui.results.a.frame, *ui.results.a.framebuffer, ui.results.overlay,
                         pixel, reach);
}

/// What an overlay has at that pixel, from the longest way to say it to the shortest.
std::vector<std::string> value_forms(const Ui& ui, const std::string& value) {
    if (value.empty()) return {};
    if (ui.canvas.hovered_pixel)
        return {"at the pixel pointed at: " + value, "here: " + value, value};
    return {"at the picked pixel: " + value, "picked pixel: " + value, value};
}

/// Shares of the canvas for the legend: with the keys of scales, and at most.
constexpr float largest_roomy_part = 0.2f, largest_part = 0.4f;

/// An overlay has at least this width in the legend, design pixels.
constexpr float least_entry_width = 280.0f;

/// The overlays that share a line.
using LegendLine = std::vector<OverlayInfo>;

/// What the legend is drawn with.
struct Legend {
    Ui& ui;
    float u;       ///< design pixel
    float line;    ///< height of a line of text
    float padding; ///< around all, and between the overlays
    bool compact;  ///< one line an overlay: in small windows
    std::vector<LegendLine> lines;
    float width; ///< of an overlay, about
    CostTable costs;
    std::vector<VectorEntry> vectors;

    bool has_key(Overlay overlay) const {
        if (overlay == Overlay::edge_field && !ui.results.overlay.field) return false;
        return !compact &&
               (is_scale(overlay) || (overlay == Overlay::vectors && !vectors.empty()) ||
                (overlay == Overlay::depth && !ui.results.overlay.facts.depth.empty()));
    }
    /// For the rows of costs or of vectors, screen pixels.
    float room_for_rows() const {
        return width - swatch_size(ui).x - 8.0f * u - line - 4.0f * padding;
    }
    float height(Overlay overlay) const {
        float height = has_key(overlay) ? 2.0f * line : line;
        if (overlay == Overlay::cost && !compact)
            height += line * static_cast<float>(costs.rows(room_for_rows()));
        if (overlay == Overlay::vectors && has_key(overlay))
            height += line * static_cast<float>(vector_rows(vectors, room_for_rows()) - 1);
        return height;
    }
};

/// The overlays that are shown, in lines of one or two.
std::vector<LegendLine> legend_lines(const Ui& ui, float width) {
    const std::size_t columns = width >= 2.0f * least_entry_width * ui.options.text_scale ? 2 : 1;
    std::vector<LegendLine> lines;
    for (const OverlayInfo& info : overlay_list()) {
        if (!ui.results.overlay.shown.has(info.overlay)) continue;
        if (lines.empty() || lines.back().size() == columns) lines.emplace_back();
        lines.back().push_back(info);
    }
    return lines;
}

float line_height(const Legend& l, const LegendLine& entries) {
    float height = l.line;
    for (const OverlayInfo& info : entries)
        height = std::max(height, l.height(info.overlay));
    return height;
}

float whole_height(const Legend& l) {
    float height = l.padding;
    for (const LegendLine& entries : l.lines)
        height += line_height(l, entries) + l.padding;
    return height;
}

/// @param room of the canvas
Legend legend_in(Ui& ui, ImVec2 room) {
    const float u = ui.options.text_scale;
    std::vector<LegendLine> lines = legend_lines(ui, room.x);
    const std::size_t columns = lines.empty() ? 1 : lines.front().size();
    Legend legend{ui,
                  u,
                  std::round(1.3f * ui.fonts.small->FontSize),
                  std::round(4.0f * u),
                  false,
                  std::move(lines),
                  room.x / static_cast<float>(columns),
                  cost_table(ui),
                  vector_entries(ui)};
    legend.compact = whole_height(legend) > largest_roomy_part * room.y;
    return legend;
}

void draw_scale(const Legend& l, Overlay overlay, ImVec2 at, float right) {
    const Palette& p = palette(l.ui.options.theme);
    const std::array<std::string, 2> ends = overlay_scale(overlay, l.ui.results.overlay);
    ImGui::SetCursorScreenPos(at);
    text_in(p.dim, ends[0]);
    const float last = ImGui::CalcTextSize(ends[1].c_str()).x;
    ImGui::SetCursorScreenPos({right - last, at.y});
    text_in(p.dim, ends[1]);
    const float from = at.x + ImGui::CalcTextSize(ends[0].c_str()).x + 6.0f * l.u;
    const float to = right - last - 6.0f * l.u;
    const float top = at.y + 0.25f * l.line, bottom = at.y + 0.8f * l.line;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled({from, top}, {to, bottom}, swatch_ground);
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const Tint tint = overlay_tint(overlay, static_cast<float>(i) / (steps - 1), {0, 0});
        const float step = (to - from) / steps;
        const float x = from + step * static_cast<float>(i);
        list->AddRectFilled({x, top}, {x + step, bottom}, packed_tint(tint));
    }
}

void draw_verdict_key(const Legend& l, ImVec2 at) {
    const Theme theme = l.ui.options.theme;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 swatch = swatch_size(l.ui);
    const float y = std::round(at.y + 0.5f * (ImGui::GetFontSize() - swatch.y) + l.u);
    draw_swatch(l.ui, list, {at.x, y}, Overlay::depth, 0.0f, 0.49f);
    ImGui::SetCursorScreenPos({at.x + swatch.x + 6.0f * l.u, at.y});
    text_in(colour_of(Meaning::fail, theme), "some failed");
    const float next = ImGui::GetItemRectMax().x + 16.0f * l.u;
    draw_swatch(l.ui, list, {next, y}, Overlay::depth, 0.51f, 1.0f);
    ImGui::SetCursorScreenPos({next + swatch.x + 6.0f * l.u, at.y});
    text_in(colour_of(Meaning::pass, theme), "all passed");
}

/// One overlay's legend. All of it has the tooltip.
void draw_entry(const Legend& l, const OverlayInfo& info, ImVec2 at, float right) {
    const Palette& p = palette(l.ui.options.theme);
    const ImVec2 swatch = swatch_size(l.ui);
    const std::string name = std::string("legend.").append(info.name);
    const std::string total =
        info.overlay == Overlay::vectors
            ? vector_subject(l.ui)
            : overlay_total(info.overlay, l.ui.results.a.frame, l.ui.results.overlay);
    const std::optional<glm::ivec2> pixel = pixel_in_focus(l.ui);
    const std::string value = pixel ? value_at(l.ui, info.overlay, *pixel) : std::string();
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({right - at.x, l.height(info.overlay)});
    register_widget(l.ui, name,
                    std::string(info.help) + (total.empty() ? "" : "\n" + total) +
                        (value.empty() ? "" : "\n" + value_forms(l.ui, value).front()) +
                        (info.overlay == Overlay::cost ? tooltip_lines(l.costs) : "") +
                        (info.overlay == Overlay::vectors ? tooltip_lines(l.vectors) : ""));

    draw_swatch(l.ui, ImGui::GetWindowDrawList(),
                {at.x, std::round(at.y + 0.5f * (ImGui::GetFontSize() - swatch.y) + l.u)},
                info.overlay);
    const float text_left = at.x + swatch.x + 8.0f * l.u, gap = 10.0f * l.u;
    ImGui::SetCursorScreenPos({text_left, at.y});
    text_in(p.text, info.title);
    float next = ImGui::GetItemRectMax().x + gap;
    if (info.overlay == Overlay::edge_field)
        next = draw_field_choice(l.ui, {next, at.y}, ImGui::GetFontSize()) + gap;
    // Whole words or none: the tooltip has all of it.
    std::vector<std::string> values = value_forms(l.ui, value);
    values.emplace_back();
    const std::string said = first_fitting(values, right - next);
    const float value_left = right - ImGui::CalcTextSize(said.c_str()).x;
    const std::string shown_total = first_fitting({total, total.substr(0, total.find(',')), ""},
                                                  value_left - next - (said.empty() ? 0.0f : gap));
    ImGui::SetCursorScreenPos({next, at.y});
    text_in(p.dim, shown_total);
    ImGui::SetCursorScreenPos({value_left, at.y});
    text_in(p.text, said);
    register_text(l.ui, name, said);
    if (!l.has_key(info.overlay)) return;
    const ImVec2 key{text_left, at.y + l.line};
    if (info.overlay == Overlay::depth) {
        draw_verdict_key(l, key);
    } else if (info.overlay == Overlay::vectors) {
        draw_vector_entries(l.ui, l.vectors, l.room_for_rows(), key, l.line);
    } else {
        draw_scale(l, info.overlay, key, right);
    }
    if (info.overlay == Overlay::cost) {
        draw_cost_table(l.ui, l.costs, l.room_for_rows(), {key.x, key.y + l.line}, right, l.line);
    }
}

/// Shows or hides all but the swatches.
void draw_fold_button(Ui& ui, ImVec2 corner, float side) {
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (button(ui, "legend.fold", ui.canvas.shows_legend ? "−" : "+", Look::quiet,
               ui.canvas.shows_legend ? "Collapses the legend to make room for the picture."
                                      : "Expands the legend.",
               {side, side})) {
        ui.canvas.shows_legend = !ui.canvas.shows_legend;
    }
    ImGui::PopStyleVar();
}

void draw_folded_legend(const Legend& l, ImVec2 low) {
    const ImVec2 swatch = swatch_size(l.ui);
    float x = low.x + l.padding;
    for (const OverlayInfo& info : overlay_list()) {
        if (!l.ui.results.overlay.shown.has(info.overlay)) continue;
        ImGui::SetCursorScreenPos({x, std::round(low.y + l.padding + 0.5f * (l.line - swatch.y))});
        ImGui::Dummy(swatch);
        register_widget(l.ui, std::string("legend.").append(info.name), info.help);
        draw_swatch(l.ui, ImGui::GetWindowDrawList(), ImGui::GetItemRectMin(), info.overlay);
        x += swatch.x + 6.0f * l.u;
    }
    draw_fold_button(l.ui, {x, low.y + l.padding}, l.line);
}

} // namespace

float overlay_legend_height(Ui& ui, ImVec2 room) {
    if (ui.results.overlay.shown.empty()) return 0.0f;
    // A low canvas has room for the picture alone.
    if (room.y < least_room * ui.options.text_scale) return 0.0f;
    const Legend legend = legend_in(ui, room);
    const float one = legend.line + 2.0f * legend.padding;
    if (!ui.canvas.shows_legend) return one;
    return std::max(one, std::floor(std::min(whole_height(legend), largest_part * room.y)));
}

void draw_overlay_legend(Ui& ui, ImVec2 room, ImVec2 low, ImVec2 high) {
    const Legend legend = legend_in(ui, room);
    ImGui::PushFont(ui.fonts.small);
    ImGui::SetCursorScreenPos(low);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 4.0f * legend.u);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // It scrolls where all overlays together are too much for it.
    ImGui::BeginChild("legend", {high.x - low.x, high.y - low.y}, false, ImGuiWindowFlags_NoNav);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ui.canvas.shows_legend) {
        const float width = ImGui::GetContentRegionAvail().x;
        const float right = at.x + width - legend.line - 2.0f * legend.padding;
        const auto columns = static_cast<float>(legend.lines.front().size());
        const float gap = 4.0f * legend.padding;
        const float column =
            (right - at.x - 2.0f * legend.padding - (columns - 1.0f) * gap) / columns;
        float y = at.y + legend.padding;
        for (const LegendLine& entries : legend.lines) {
            float x = at.x + 2.0f * legend.padding;
            for (const OverlayInfo& info : entries) {
                draw_entry(legend, info, {x, y}, x + column);
                x += column + gap;
            }
            y += line_height(legend, entries) + legend.padding;
        }
        ImGui::SetCursorScreenPos({at.x, y - legend.padding});
        ImGui::Dummy({0, legend.padding});
        draw_fold_button(ui, {right + legend.padding, at.y + legend.padding}, legend.line);
    } else {
        draw_folded_legend(legend, at);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

} // namespace rasterwalk
