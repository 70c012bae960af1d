#include <algorithm>
#include <array>
#include <cmath>

#include "ui/inspector/texture_parts.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Of a drawing; and how much of half of it an arrow of unit length takes. Design pixels.
constexpr float arrow_side = 92.0f, unit_share = 0.8f;

/// A circle that arrows of unit length reach, and its two axes.
struct ArrowField {
    ImDrawList* list;
    float u;
    ImVec2 origin;
    float unit; ///< screen pixels

    ImVec2 at(double right, double up) const {
        return {origin.x + unit * static_cast<float>(right),
                origin.y - unit * static_cast<float>(up)};
    }
};

/// A name at the end of an axis.
struct AxisName {
    double right, up;
    const char* words;
};

void draw_field(const Ui& ui, const ArrowField& field, bool is_half,
                const std::array<AxisName, 2>& names) {
    const Palette& p = palette(ui.options.theme);
    constexpr float half_turn = 3.14159265f;
    field.list->PathArcTo(field.origin, field.unit, is_half ? half_turn : 0.0f, 2.0f * half_turn,
                          48);
    field.list->PathStroke(packed(p.dim), 0, field.u);
    field.list->AddLine(field.at(-1.0, 0.0), field.at(1.0, 0.0), packed(p.dim), field.u);
    field.list->AddLine(field.at(0.0, is_half ? 0.0 : -1.0), field.at(0.0, 1.0), packed(p.dim),
                        field.u);
    for (const AxisName& name : names) {
        const ImVec2 end = field.at(1.12 * name.right, 1.12 * name.up);
        const float x = name.right != 0.0 ? end.x : end.x - 0.5f * text_width(name.words);
        const float y =
            name.up != 0.0 ? end.y - ImGui::GetFontSize() : end.y - 0.5f * ImGui::GetFontSize();
        field.list->AddText({std::round(x), std::round(y)}, packed(p.dim), name.words);
    }
}

void draw_in_field(const Ui& ui, const ArrowField& field, double right, double up) {
    if (!std::isfinite(right) || !std::isfinite(up)) return;
    const ImU32 ink = packed(palette(ui.options.theme).text);
    field.list->AddCircleFilled(field.origin, 2.5f * field.u, ink);
    draw_arrow(field.list, field.u, field.origin, field.at(right, up), {ink, 0});
}

} // namespace

void draw_map_arrow(Ui& ui, const BumpReport& bump) {
    draw_number_links(ui, {"arrow  ", axis_names, bump.arrow, "bump.arrow.", "texture.arrow.",
                           " of the arrow that the colour stands for.\nClick to see how it was "
                           "calculated."});
    const float u = ui.options.text_scale, side = arrow_side * u;
    const float unit = 0.5f * unit_share * side;
    ImGui::PushFont(ui.fonts.small);
    const float line = ImGui::GetFontSize();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float names = text_width("toward") + 6.0f * u;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float middle = start.y + line + 4.0f * u + unit;
    const ArrowField above{list, u, {start.x + unit + 2.0f * u, middle}, unit};
    const ArrowField from_side{
        list, u, {above.origin.x + 2.0f * unit + names + 24.0f * u, middle + 0.5f * unit}, unit};
    draw_field(ui, above, false, {{{1.0, 0.0, "x: u"}, {0.0, 1.0, "y: top"}}});
    draw_in_field(ui, above, bump.arrow.x, bump.arrow.y);
    // Cut along the direction in which it leans.
    draw_field(ui, from_side, true, {{{1.0, 0.0, "lean"}, {0.0, 1.0, "z: out"}}});
    draw_in_field(ui, from_side, std::hypot(double{bump.arrow.x}, double{bump.arrow.y}),
                  bump.arrow.z);
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, line + 4.0f * u + 2.0f * unit + 4.0f * u});
    register_widget(ui, "texture.arrow",
                    "The arrow that the colour stands for. On the left seen from above: x along u, "
                    "y toward the top of the texture. On the right seen from the side, along the "
                    "direction in which it leans: z out of the surface. Arrows of unit length "
                    "reach the circle.");
    ImGui::PopFont();
}

} // namespace rasterwalk
