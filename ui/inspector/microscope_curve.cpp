#include <algorithm>
#include <cmath>
#include <string>

#include "explain/line_rules.h"
#include "ui/inspector/microscope_parts.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_drift_curve(Ui& ui) {
    const EdgeMicroscope& edge = ui.inspector.microscope.shown;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = 58.0f * u;
    const ImVec2 high{low.x + width, low.y + height};
    ImGui::InvisibleButton("microscope.curve", {width, height});
    const bool is_held = ImGui::IsItemActive();
    register_widget(
        ui, "microscope.curve",
        edge.has_decision_variable()
            ? "The decision variable d along the edge. Each step brings it back toward 0. "
              "Click or drag to go to a sample."
            : "How far the float is from the exact fraction, along the edge. Marks show "
              "samples on a wrong pixel. Click or drag to go to a sample.");
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, packed(p.card), 5.0f * u);
    const int last = std::max(edge.count - 1, 1);
    const float inset = 12.0f * u;
    const auto x_of = [&](int sample) {
        return low.x + inset +
               (width - 2.0f * inset) * static_cast<float>(sample) / static_cast<float>(last);
    };
    const MicroscopeSummary& summary = edge.summary;
    const bool shows_decision = edge.has_decision_variable();
    const double drift =
        ui.inspector.microscope.shows_x ? summary.largest_drift_x : summary.largest_drift_y;
    const double largest = shows_decision ? summary.largest_decision : drift;
    const auto value_at = [&](int sample) {
        return shows_decision ? edge.decisions[static_cast<std::size_t>(sample)].before
                              : shown_coordinate(ui, edge.at(sample)).drift;
    };
    const float middle = low.y + 0.5f * height;
    const auto y_of = [&](double value) {
        const double share = largest != 0.0 ? value / std::abs(largest) : 0.0;
        return middle - 0.32f * height * static_cast<float>(share);
    };
    list->AddLine({low.x + inset, middle}, {high.x - inset, middle}, packed(p.line));
    // At most two samples a screen pixel: more cannot be seen.
    const int stride = std::max(1, edge.count / std::max(1, static_cast<int>(2.0f * width)));
    ImVec2 before{x_of(0), y_of(value_at(0))};
    for (int i = 0; i < edge.count; i += stride) {
        const ImVec2 here{x_of(i), y_of(value_at(i))};
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
    const std::string label =
        shows_decision ? "decision d, up to " + with_minus_signs(decision_number(largest))
                       : std::string("drift of ") + (ui.inspector.microscope.shows_x ? "x" : "y") +
                             (largest != 0.0 ? ", reaching " + drift_text(largest) : ": none");
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

} // namespace rasterwalk
