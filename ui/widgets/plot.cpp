#include "ui/widgets/plot.h"

#include <algorithm>
#include <cmath>

#include "ui/ui.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// More points than this on a curve cannot be told apart.
constexpr int most_points = 1000;

/// Converts numbers to screen pixels.
struct Scale {
    ImVec2 low, high; ///< corners of the field
    Interval x, y;

    float to_x(double value) const {
        return low.x + (high.x - low.x) * static_cast<float>((value - x.low) / (x.high - x.low));
    }
    float to_y(double value) const {
        const double share = (value - y.low) / (y.high - y.low);
        return high.y - (high.y - low.y) * static_cast<float>(std::clamp(share, -1.0, 2.0));
    }
};

/// The smallest and largest finite value of all curves.
Interval range_of(const Plot& plot) {
    Interval range{HUGE_VAL, -HUGE_VAL};
    const int step = std::max(plot.count / most_points, 1);
    for (const Curve& curve : plot.curves) {
        for (int i = 0; i < plot.count; i += step) {
            const double value = curve.value(i);
            if (!std::isfinite(value)) continue;
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    }
    return range.low <= range.high ? range : Interval{0.0, 1.0};
}

/// The indices at which points are drawn: every one, or evenly thinned; always the last.
std::vector<int> drawn_indices(const Plot& plot) {
    std::vector<int> indices;
    const int step = std::max((plot.count + most_points - 1) / most_points, 1);
    for (int i = 0; i < plot.count; i += step)
        indices.push_back(i);
    if (indices.back() != plot.count - 1) indices.push_back(plot.count - 1);
    return indices;
}

void draw_dashed(ImDrawList* list, const std::vector<ImVec2>& points, ImU32 colour, float width,
                 float dash) {
    float walked = 0.0f;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ImVec2 a = points[i - 1], b = points[i];
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        for (float at = 0.0f; at < length;) {
            const float in_period = std::fmod(walked, 2.0f * dash);
            const bool is_on = in_period < dash;
            const float until = (is_on ? dash : 2.0f * dash) - in_period;
            const float end = std::min(at + std::max(until, 0.1f), length);
            if (is_on) {
                list->AddLine({a.x + (b.x - a.x) * at / length, a.y + (b.y - a.y) * at / length},
                              {a.x + (b.x - a.x) * end / length, a.y + (b.y - a.y) * end / length},
                              colour, width);
            }
            walked += end - at;
            at = end;
        }
    }
}

void draw_curve(Ui& ui, const Plot& plot, const Curve& curve, const Scale& scale) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float u = ui.options.text_scale;
    std::vector<ImVec2> points;
    const auto flush = [&] {
        const ImU32 colour = packed(curve.colour);
        if (points.size() == 1) {
            list->AddCircleFilled(points[0], 3.0f * u, colour);
        } else if (curve.is_dashed) {
            draw_dashed(list, points, colour, 1.6f * u, 5.0f * u);
        } else if (!points.empty()) {
            list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 2.0f * u);
        }
        points.clear();
    };
    for (const int i : drawn_indices(plot)) {
        const double value = curve.value(i);
        if (!std::isfinite(value)) {
            flush();
            continue;
        }
        points.emplace_back(scale.to_x(plot.first_x + i), scale.to_y(value));
    }
    flush();
}

void draw_band(const Plot& plot, const Scale& scale, ImU32 colour) {
    if (plot.band_from < 0 || plot.band_to < 0) return;
    const Curve& a = plot.curves[static_cast<std::size_t>(plot.band_from)];
    const Curve& b = plot.curves[static_cast<std::size_t>(plot.band_to)];
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::vector<int> indices = drawn_indices(plot);
    // Anti-aliased fills of neighbours would leave seams.
    const ImDrawListFlags flags = list->Flags;
    list->Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t k = 1; k < indices.size(); ++k) {
        const int i = indices[k - 1], j = indices[k];
        const double ai = a.value(i), aj = a.value(j), bi = b.value(i), bj = b.value(j);
        if (!std::isfinite(ai + aj + bi + bj)) continue;
        const float xi = scale.to_x(plot.first_x + i), xj = scale.to_x(plot.first_x + j);
        list->AddQuadFilled({xi, scale.to_y(ai)}, {xj, scale.to_y(aj)}, {xj, scale.to_y(bj)},
                            {xi, scale.to_y(bi)}, colour);
    }
    list->Flags = flags;
}

void draw_axes(Ui& ui, const Plot& plot, const Scale& scale, float left, const Ticks& x,
               const Ticks& y) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float line = ImGui::GetFontSize();
    for (const double tick : y.places) {
        const float at = std::floor(scale.to_y(tick)) + 0.5f;
        list->AddLine({scale.low.x, at}, {scale.high.x, at}, packed(p.line));
        const std::string label = fixed(tick, y.digits);
        list->AddText({scale.low.x - text_width(label) - 6.0f * u, at - 0.5f * line}, packed(p.dim),
                      label.c_str());
    }
    const float name_end = left + text_width(plot.x_name) + 6.0f * u;
    list->AddText({left, scale.high.y + 5.0f * u}, packed(p.dim), plot.x_name.c_str());
    for (const double tick : x.places) {
        const float at = std::floor(scale.to_x(tick)) + 0.5f;
        list->AddLine({at, scale.high.y}, {at, scale.high.y + 4.0f * u}, packed(p.dim));
        if (plot.x_name.empty()) continue;
        const std::string label = fixed(tick, x.digits);
        // The name of the axis comes before its numbers.
        if (at - 0.5f * text_width(label) < name_end) continue;
        list->AddText({at - 0.5f * text_width(label), scale.high.y + 5.0f * u}, packed(p.dim),
                      label.c_str());
    }
    list->AddLine({scale.low.x, scale.high.y}, {scale.high.x, scale.high.y}, packed(p.dim));
}

/// Shades where the row is outside the picture, because those columns are never drawn.
void draw_outside(Ui& ui, const Plot& plot, const Scale& scale) {
    const ImU32 colour = packed(palette(ui.options.theme).line, 0.5f);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (plot.first_x < plot.valid_from) {
        const float end = std::min(scale.to_x(plot.valid_from), scale.high.x);
        list->AddRectFilled(scale.low, {end, scale.high.y}, colour);
    }
    if (plot.first_x + plot.count > plot.valid_to) {
        const float begin = std::max(scale.to_x(plot.valid_to - 1), scale.low.x);
        list->AddRectFilled({begin, scale.low.y}, scale.high, colour);
    }
}

void draw_column(Ui& ui, const Plot& plot, const Scale& scale, int index, const ImVec4& colour,
                 float opacity) {
    const float u = ui.options.text_scale;
    const float x = std::floor(scale.to_x(plot.first_x + index)) + 0.5f;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddLine({x, scale.low.y}, {x, scale.high.y}, packed(colour, opacity), u);
    for (const Curve& curve : plot.curves) {
        const double value = curve.value(index);
        if (!std::isfinite(value)) continue;
        const ImVec2 at{x, scale.to_y(value)};
        list->AddCircleFilled(at, 4.5f * u, packed(palette(ui.options.theme).card));
        list->AddCircleFilled(at, 3.2f * u, packed(curve.colour));
    }
}

/// The height of the field in a plot of this height.
float field_height(const Ui& ui, const Plot& plot, float height) {
    const float u = ui.options.text_scale;
    const float below = plot.x_name.empty() ? 5.0f * u : ui.fonts.small->FontSize + 8.0f * u;
    return std::max(height - below - 4.0f * u, 1.0f);
}

Ticks y_ticks(const Ui& ui, const Interval& range, float height) {
    return nice_ticks(range,
                      std::max(static_cast<int>(height / (2.2f * ui.fonts.small->FontSize)), 3));
}

Ticks x_ticks(const Interval& range, float width) {
    const float room = text_width("00000") * 1.4f;
    Ticks ticks = nice_ticks(range, std::max(static_cast<int>(width / room), 2));
    // Columns are whole numbers.
    if (ticks.digits > 0) ticks = {{std::ceil(range.low), std::floor(range.high)}, 0};
    return ticks;
}

/// The index of the column under the pointer.
int index_under_pointer(const Plot& plot, const Scale& scale) {
    const double share = static_cast<double>(ImGui::GetIO().MousePos.x - scale.low.x) /
                         static_cast<double>(scale.high.x - scale.low.x);
    const double x = scale.x.low + share * (scale.x.high - scale.x.low) - plot.first_x;
    return static_cast<int>(std::lround(std::clamp(x, 0.0, static_cast<double>(plot.count - 1))));
}

} // namespace

float axis_width(Ui& ui, const Plot& plot, float height) {
    ImGui::PushFont(ui.fonts.small);
    const Ticks ticks =
        y_ticks(ui, with_margin(range_of(plot), 0.08), field_height(ui, plot, height));
    float width = 0.0f;
    for (const double tick : ticks.places)
        width = std::max(width, text_width(fixed(tick, ticks.digits)));
    ImGui::PopFont();
    return width + 8.0f * ui.options.text_scale;
}

int draw_plot(Ui& ui, const std::string& name, const Plot& plot, ImVec2 size, float axis,
              int pointed) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(name.c_str(), size);
    const bool is_hovered = ImGui::IsItemHovered();
    register_widget(ui, name);

    Scale scale;
    scale.y = with_margin(range_of(plot), 0.08);
    scale.x = {static_cast<double>(plot.first_x),
               static_cast<double>(plot.first_x + plot.count - 1)};
    if (plot.count == 1) scale.x = {scale.x.low - 1.0, scale.x.high + 1.0};
    const float height = field_height(ui, plot, size.y);
    scale.low = {start.x + axis, start.y + 4.0f * u};
    scale.high = {std::max(start.x + size.x - 8.0f * u, scale.low.x + 1.0f), scale.low.y + height};

    ImGui::PushFont(ui.fonts.small);
    draw_outside(ui, plot, scale);
    draw_axes(ui, plot, scale, start.x, x_ticks(scale.x, scale.high.x - scale.low.x),
              y_ticks(ui, scale.y, height));
    ImGui::PopFont();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->PushClipRect({scale.low.x - 5.0f * u, scale.low.y - 4.0f * u},
                       {scale.high.x + 6.0f * u, scale.high.y + 4.0f * u}, true);
    draw_band(plot, scale, packed(colour_of(Meaning::fail, ui.options.theme), 0.22f));
    for (const Curve& curve : plot.curves)
        draw_curve(ui, plot, curve, scale);
    if (plot.marked >= 0) {
        draw_column(ui, plot, scale, plot.marked, colour_of(Meaning::current, ui.options.theme),
                    0.8f);
    }
    if (is_hovered) pointed = index_under_pointer(plot, scale);
    if (pointed >= 0) draw_column(ui, plot, scale, pointed, p.dim, 1.0f);
    list->PopClipRect();
    return is_hovered ? pointed : -1;
}

void draw_legend(Ui& ui, const std::string& name, const Plot& plot, int index,
                 const std::string& tooltip) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const float sample = 20.0f * u, gap = 5.0f * u;
    ImGui::PushFont(ui.fonts.small);
    struct Entry {
        std::string label, number;
        const Curve* curve; ///< null: the band
    };
    std::vector<Entry> entries;
    for (const Curve& curve : plot.curves)
        entries.push_back({curve.label + " ", fixed(curve.value(index), 5), &curve});
    if (plot.band_from >= 0 && plot.band_to >= 0) {
        const double a = plot.curves[static_cast<std::size_t>(plot.band_from)].value(index);
        const double b = plot.curves[static_cast<std::size_t>(plot.band_to)].value(index);
        entries.push_back({"off by ", fixed(std::abs(a - b), 5), nullptr});
    }
    std::vector<float> widths;
    for (const Entry& entry : entries)
        widths.push_back(sample + gap + text_width(entry.label) + text_width("−0.00000"));
    const std::vector<FlowPlace> places = flow(widths, 10.0f * u, ImGui::GetContentRegionAvail().x);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight() + 3.0f * u;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        const ImVec2 at{start.x + places[i].x, start.y + static_cast<float>(places[i].line) * line};
        const float y = std::floor(at.y + 0.5f * ImGui::GetTextLineHeight()) + 0.5f;
        if (entry.curve == nullptr) {
            list->AddRectFilled({at.x, y - 5.0f * u}, {at.x + sample, y + 5.0f * u},
                                packed(colour_of(Meaning::fail, ui.options.theme), 0.3f));
        } else if (entry.curve->is_dashed) {
            draw_dashed(list, {{at.x, y}, {at.x + sample, y}}, packed(entry.curve->colour),
                        1.6f * u, 5.0f * u);
        } else {
            list->AddLine({at.x, y}, {at.x + sample, y}, packed(entry.curve->colour), 2.0f * u);
        }
        const float x = at.x + sample + gap;
        list->AddText({x, at.y}, packed(p.dim), entry.label.c_str());
        list->AddText({x + text_width(entry.label), at.y}, packed(p.text), entry.number.c_str());
        clip_range_to_lines(at.y, at.y + ImGui::GetTextLineHeight());
    }
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, static_cast<float>(line_count(places)) * line});
    ImGui::PopFont();
    register_widget(ui, name, tooltip);
}

} // namespace rasterwalk
