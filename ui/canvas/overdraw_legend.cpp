#include "ui/canvas/overdraw_legend.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "ui/actions/compare.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The numbers that have a box each: all from 0 to the largest, or as many in equal steps as there
/// is room for, and the largest.
std::vector<std::uint32_t> listed_numbers(std::uint32_t most, std::uint32_t boxes) {
    const std::uint32_t room = std::max(boxes, 2u) - 1;
    const std::uint32_t step = most / room + (most % room != 0 ? 1 : 0);
    std::vector<std::uint32_t> numbers;
    for (std::uint64_t n = 0; n < most; n += std::max(step, 1u))
        numbers.push_back(static_cast<std::uint32_t>(n));
    numbers.push_back(most);
    return numbers;
}

/// The fragments on the pixel pointed at or picked.
std::optional<std::uint32_t> overdraw_in_focus(const Ui& ui) {
    const std::optional<glm::ivec2> pixel = pixel_in_focus(ui);
    if (!pixel) return std::nullopt;
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    return framebuffer.overdraw[framebuffer.at(pixel->x, pixel->y)];
}

std::string box_tooltip(const OverdrawCounts& counts, std::uint32_t number) {
    std::string text = "Pixels on which " + counted(number, "fragment", "fragments") + " fell";
    if (number < counts.pixels.size()) {
        text += ": " + counted(counts.pixels[number], "pixel", "pixels");
    } else if (number > 0 && number <= most_overdraw_listed) {
        text += ": 0 pixels";
    }
    return text + ".";
}

} // namespace

float overdraw_legend_height(const Ui& ui) {
    if (ui.session.view != View::overdraw || !ui.results.overdraw) return 0.0f;
    // Run B has colours for its own numbers.
    if (is_comparing(ui) && ui.session.compare_view != CompareView::run_a) return 0.0f;
    return ui.fonts.small->FontSize + 12.0f * ui.options.text_scale;
}

void draw_overdraw_legend(Ui& ui, ImVec2 low, ImVec2 high) {
    if (!ui.results.overdraw) return;
    const OverdrawCounts& counts = *ui.results.overdraw;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    const float text_y = std::round(0.5f * (low.y + high.y - ImGui::GetFontSize()));
    const std::string most = std::to_string(counts.most);
    const float box = std::ceil(std::max(text_width(most), text_width("00")) + 10.0f * u);
    const float width = high.x - low.x;
    // In a narrow canvas the boxes come first.
    const std::string title = width > 16.0f * box ? "fragments on a pixel" : "fragments";
    const bool has_title = width > text_width(title) + 5.0f * box;
    const float left = low.x + (has_title ? text_width(title) + 12.0f * u : 0.0f);
    const std::optional<std::uint32_t> here = overdraw_in_focus(ui);
    const float room_for_here = text_width("here " + most) + 12.0f * u;
    const bool has_here = high.x - room_for_here > left + 3.0f * box;
    const float right = high.x - (has_here ? room_for_here : 0.0f);
    if (has_title) {
        ImGui::SetCursorScreenPos({low.x, text_y});
        text_in(p.dim, title);
    }
    if (has_here && here) {
        const std::string words = "here " + std::to_string(*here);
        ImGui::SetCursorScreenPos({high.x - text_width(words), text_y});
        text_in(p.text, words);
        register_widget(ui, "overdraw.here",
                        "Fragments on the pixel you point at, or else on the picked one.",
                        std::to_string(*here));
    }
    const auto boxes = static_cast<std::uint32_t>(std::max((right - left) / box, 2.0f));
    const std::vector<std::uint32_t> numbers = listed_numbers(counts.most, boxes);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::uint32_t number = numbers[i];
        const auto rgb = overdraw_colour(number, counts.most);
        const ImVec2 corner{left + box * static_cast<float>(i), low.y};
        list->AddRectFilled(corner, {corner.x + box, high.y}, IM_COL32(rgb.r, rgb.g, rgb.b, 255));
        const bool is_here =
            here && *here >= number && (i + 1 == numbers.size() || *here < numbers[i + 1]);
        if (is_here) {
            const float inset = 1.0f * u;
            list->AddRect({corner.x + inset, corner.y + inset},
                          {corner.x + box - inset, high.y - inset}, IM_COL32(0, 0, 0, 255), 0.0f, 0,
                          3.5f * u);
            list->AddRect({corner.x + inset, corner.y + inset},
                          {corner.x + box - inset, high.y - inset}, IM_COL32(255, 255, 255, 255),
                          0.0f, 0, 1.5f * u);
        }
        const std::string text = std::to_string(number);
        ImGui::SetCursorScreenPos({std::round(corner.x + 0.5f * (box - text_width(text))), text_y});
        const ImVec4 ink = has_dark_ink(rgb) ? ImVec4(0, 0, 0, 1) : ImVec4(1, 1, 1, 1);
        text_in(ink, text);
        ImGui::SetCursorScreenPos(corner);
        ImGui::Dummy({box, high.y - low.y});
        register_widget(ui, "overdraw.count." + text, box_tooltip(counts, number));
    }
    list->AddRect({left, low.y}, {left + box * static_cast<float>(numbers.size()), high.y},
                  packed(p.line));
    ImGui::PopFont();
}

} // namespace rasterwalk
