#include "ui/canvas/difference_legend.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "session/results.h"
#include "ui/actions/compare.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Heights, design pixels.
constexpr float scale_height = 46.0f, low_scale_height = 18.0f;

std::string difference_of_depths(const Ui& ui) {
    const DepthWords& a = depth_words(ui.results.a.frame);
    const DepthWords& b = depth_words(ui.results.b->frame);
    return fmt::format("B − A, {}",
                       a.kind == b.kind ? a.name : std::string_view("two kinds of depth"));
}

std::string difference_unit(const Ui& ui, View view) {
    switch (view) {
    case View::colour:
        return "B − A, linear colour of the channel that differs most";
    case View::depth:
        return difference_of_depths(ui);
    case View::triangle:
        return "another triangle";
    case View::overdraw:
        return "B − A, fragments";
    }
    return "";
}

/// The difference at the pixel asked about.
std::optional<float> difference_in_focus(const Ui& ui) {
    const std::optional<glm::ivec2> pixel = pixel_in_focus(ui);
    if (!pixel) return std::nullopt;
    const std::size_t at = ui.results.a.framebuffer->at(pixel->x, pixel->y);
    return ui.results.comparison.difference_values[at];
}

/// What the scale measures, and the number in focus; from the longest form to the shortest.
std::vector<std::string> difference_words(const Ui& ui) {
    const std::string unit = difference_unit(ui, ui.session.view);
    const std::optional<float> value = difference_in_focus(ui);
    if (!value) return {unit, "B − A"};
    const std::optional<glm::ivec2> pixel = pixel_in_focus(ui);
    const std::string at =
        fmt::format("at ({}, {}): {}{}", pixel->x, pixel->y, *value > 0.0f ? "+" : "",
                    fixed(static_cast<double>(*value), 4));
    return {unit + " · " + at, "B − A " + at, at};
}

/// The numbers at the left end, in the middle and at the right end of the scale.
std::array<std::string, 3> difference_ends(float limit) {
    const std::string number = significant(static_cast<double>(limit), 6);
    return {"−" + number, "0", "+" + number};
}

/// The colours of the scale, and a mark at the number in focus.
void draw_difference_bar(const Ui& ui, ImVec2 low, ImVec2 high) {
    const float limit = ui.results.comparison.difference_limit;
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    constexpr int steps = 96;
    for (int i = 0; i < steps; ++i) {
        const float value = limit * (2.0f * (static_cast<float>(i) + 0.5f) / steps - 1.0f);
        const auto colour = difference_colour(value, limit);
        const float from = low.x + (high.x - low.x) * static_cast<float>(i) / steps;
        const float to = low.x + (high.x - low.x) * static_cast<float>(i + 1) / steps;
        list->AddRectFilled({from, low.y}, {to, high.y},
                            IM_COL32(colour.r, colour.g, colour.b, 255));
    }
    const std::optional<float> value = difference_in_focus(ui);
    if (!value) return;
    const float place = std::clamp(0.5f + 0.5f * *value / limit, 0.0f, 1.0f);
    const float x = low.x + place * (high.x - low.x);
    list->AddRectFilled({x - 2.5f * u, low.y - 2.0f * u}, {x + 2.5f * u, high.y + 2.0f * u},
                        IM_COL32(0, 0, 0, 255));
    list->AddRectFilled({x - 1.0f * u, low.y - 1.0f * u}, {x + 1.0f * u, high.y + 1.0f * u},
                        IM_COL32(255, 255, 255, 255));
}

} // namespace

float difference_legend_height(const Ui& ui, float canvas_height) {
    const bool shows = is_comparing(ui) && ui.session.compare_view == CompareView::difference;
    if (!shows) return 0.0f;
    const float u = ui.options.text_scale;
    return std::round((canvas_height < low_canvas * u ? low_scale_height : scale_height) * u);
}

void draw_difference_legend(Ui& ui, ImVec2 low, ImVec2 high) {
    const ComparisonResults& comparison = ui.results.comparison;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImGui::PushFont(ui.fonts.small);
    const std::array<std::string, 3> ends = difference_ends(comparison.difference_limit);
    if (high.y - low.y < scale_height * u - 1.0f) {
        // The numbers next to the colours.
        const float side = ImGui::CalcTextSize(ends[0].c_str()).x + 6.0f * u;
        const float y = low.y + 0.5f * (high.y - low.y - ImGui::GetFontSize());
        list->AddText({low.x, y}, packed(p.dim), ends[0].c_str());
        list->AddText({high.x - side + 6.0f * u, y}, packed(p.dim), ends[2].c_str());
        draw_difference_bar(ui, {low.x + side, low.y + 4.0f * u},
                            {high.x - side, high.y - 4.0f * u});
    } else {
        const float top = low.y + ui.fonts.small->FontSize + 4.0f * u;
        const float bottom = top + 10.0f * u;
        draw_difference_bar(ui, {low.x, top}, {high.x, bottom});
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const float width = ImGui::CalcTextSize(ends[i].c_str()).x;
            const float share = 0.5f * static_cast<float>(i);
            list->AddText({low.x + share * (high.x - low.x - width), bottom + 3.0f * u},
                          packed(p.dim), ends[i].c_str());
        }
        ImGui::SetCursorScreenPos(low);
        text_in(p.text, first_fitting(difference_words(ui), high.x - low.x));
    }
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({high.x - low.x, high.y - low.y});
    register_widget(ui, "compare.scale",
                    "What the colours of the difference mean: blue where B is less than A, orange "
                    "where it is more, black where they are equal.\n" +
                        difference_words(ui).front());
}

} // namespace rasterwalk
