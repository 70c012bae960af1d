#include "ui/canvas/depth_legend.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "picture/colour_map.h"
#include "picture/view_image.h"
#include "session/depth_view.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A canvas lower than this, in design pixels, gets a flatter histogram.
constexpr float roomy_height = 340.0f;

/// Design pixels: the histogram, and the strip of colour under it.
constexpr float bars_height = 44.0f;
constexpr float flat_bars_height = 26.0f;
constexpr float strip_height = 8.0f;

float bars_height_of(const Ui& ui, float canvas_height) {
    const float u = ui.options.text_scale;
    return std::round((canvas_height < roomy_height * u ? flat_bars_height : bars_height) * u);
}

/// A stored value with its z: "0.2499 (z 4.001)".
std::string depth_text(const Ui& ui, float depth) {
    return fixed(static_cast<double>(depth), 4) + " (z " +
           fixed(z_of_stored_depth(ui.results.a.frame, depth), 3) + ")";
}

/// The same, and without the z for lack of room.
std::vector<std::string> depth_forms(const Ui& ui, const std::string& name, float depth) {
    return {name + " " + depth_text(ui, depth), name + " " + fixed(static_cast<double>(depth), 4)};
}

/// What the depth buffer holds.
std::string depth_name(const Ui& ui) {
    return std::string(depth_words(ui.results.a.frame).name);
}

/// Where the histogram lies on the screen.
struct Plot {
    const DepthView& view;
    ImVec2 low, high; ///< bars and strip of colour
    float strip_top;

    float x(float depth) const {
        const float place = std::clamp(view.histogram.axis.place(depth), 0.0f, 1.0f);
        return low.x + place * (high.x - low.x);
    }
    float value(float screen_x) const {
        const DepthRange& axis = view.histogram.axis;
        return axis.far + (screen_x - low.x) / (high.x - low.x) * (axis.near - axis.far);
    }
    ImU32 colour(float depth) const {
        const float place = view.range.place(depth);
        const auto rgb = viridis(place > 0.0f ? place : 0.0f);
        return IM_COL32(rgb.r, rgb.g, rgb.b, 255);
    }
};

void draw_bars(const Ui& ui, ImDrawList* list, const Plot& plot) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    list->AddRectFilled(plot.low, plot.high, packed(p.canvas), 3.0f * u);
    const auto count = static_cast<float>(depth_bins);
    const float width = (plot.high.x - plot.low.x) / count;
    const float room = plot.strip_top - plot.low.y - 3.0f * u;
    for (int b = 0; b < depth_bins; ++b) {
        const float left = plot.low.x + width * static_cast<float>(b);
        const ImU32 colour = plot.colour(plot.value(left + 0.5f * width));
        list->AddRectFilled({left, plot.strip_top}, {left + width, plot.high.y}, colour);
        const std::int64_t pixels = plot.view.histogram.bins[static_cast<std::size_t>(b)];
        if (pixels == 0) continue;
        const double share =
            static_cast<double>(pixels) / static_cast<double>(plot.view.histogram.full);
        const float height =
            std::clamp(static_cast<float>(std::min(share, 1.0)) * room, 1.5f * u, room);
        const float top = plot.strip_top - height;
        list->AddRectFilled({left, top}, {left + width, plot.strip_top}, colour);
        if (share <= 1.0) continue;
        // A gap shows that the bar continues.
        list->AddRectFilled({left, top + 4.0f * u}, {left + width, top + 6.0f * u},
                            packed(p.canvas));
    }
}

/// The part of the axis outside the range, dimmed.
void draw_outside(const Ui& ui, ImDrawList* list, const Plot& plot) {
    const ImU32 dim = packed(palette(ui.options.theme).canvas, 0.62f);
    list->AddRectFilled(plot.low, {plot.x(plot.view.range.far), plot.strip_top}, dim);
    list->AddRectFilled({plot.x(plot.view.range.near), plot.low.y}, {plot.high.x, plot.strip_top},
                        dim);
}

/// A handle to drag; returns where it has been dragged to.
std::optional<float> draw_handle(Ui& ui, const Plot& plot, bool is_near) {
    const float u = ui.options.text_scale;
    const float x = std::round(plot.x(is_near ? plot.view.range.near : plot.view.range.far));
    // Each is dragged by its outer side, so that they can be close together.
    const float inner = 3.0f * u, outer = 11.0f * u;
    const float left = x - (is_near ? inner : outer);
    ImGui::SetCursorScreenPos({left, plot.low.y});
    const char* const name = is_near ? "depth.near" : "depth.far";
    ImGui::InvisibleButton(name, {inner + outer, plot.high.y - plot.low.y});
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const float mouse = ImGui::GetIO().MousePos.x;
    if (ImGui::IsItemActivated()) ui.canvas.depth_grip = mouse - x;
    const DepthWords& words = depth_words(ui.results.a.frame);
    const bool is_dragged = ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0.0f;
    register_widget(ui, name,
                    is_near ? "The near end of the range: " + std::string(words.nearer) + " " +
                                  depth_name(ui) + " takes the brightest colour. Drag it."
                            : "The far end of the range: " + std::string(words.farther) + " " +
                                  depth_name(ui) + " takes the darkest colour. Drag it.");
    const Palette& p = palette(ui.options.theme);
    const ImU32 colour = packed(lit ? p.link : p.text);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled({x - 1.0f * u, plot.low.y}, {x + 1.0f * u, plot.high.y}, colour);
    const float side = is_near ? 1.0f : -1.0f;
    const ImVec2 grip_low{std::min(x, x + side * 8.0f * u), plot.low.y};
    list->AddRectFilled(grip_low, {grip_low.x + 8.0f * u, plot.low.y + 14.0f * u}, colour,
                        2.0f * u);
    const float middle = x + side * 4.0f * u;
    for (const float dx : {-1.5f, 1.5f}) {
        list->AddLine({middle + dx * u, plot.low.y + 4.0f * u},
                      {middle + dx * u, plot.low.y + 10.0f * u}, packed(p.card), u);
    }
    if (is_dragged) return plot.value(mouse - ui.canvas.depth_grip);
    const int more = take_arrows(ui, name).more();
    if (more == 0) return std::nullopt;
    return plot.value(x + static_cast<float>(more) * u);
}

/// Where the pixel pointed at is among all others.
void draw_pointer(const Ui& ui, ImDrawList* list, const Plot& plot, float depth) {
    const float u = ui.options.text_scale;
    const float x = std::round(plot.x(depth));
    const ImU32 colour = packed(colour_of(Meaning::current, ui.options.theme));
    list->AddLine({x, plot.low.y}, {x, plot.high.y}, colour, 1.5f * u);
    list->AddTriangleFilled({x - 5.0f * u, plot.low.y}, {x + 5.0f * u, plot.low.y},
                            {x, plot.low.y + 6.0f * u}, colour);
}

/// What a bar means, while the pointer rests on it.
std::string bar_text(const Plot& plot, float x, const std::string& name) {
    const DepthHistogram& histogram = plot.view.histogram;
    const float width = (plot.high.x - plot.low.x) / static_cast<float>(depth_bins);
    // The pointer may be anywhere, even beyond the range of an int.
    const int bin = static_cast<int>(
        std::clamp((x - plot.low.x) / width, 0.0f, static_cast<float>(depth_bins - 1)));
    const float left = plot.low.x + width * static_cast<float>(bin);
    const std::int64_t pixels = histogram.bins[static_cast<std::size_t>(bin)];
    return name + " from " + fixed(plot.value(left), 4) + " to " +
           fixed(plot.value(left + width), 4) + ": " + counted(pixels, "pixel", "pixels") +
           (pixels > histogram.full ? ". The bar is cut off." : ".");
}

/// The stored depth of the pixel pointed at or picked; none: it has none.
std::optional<float> depth_in_focus(const Ui& ui) {
    const std::optional<glm::ivec2> pixel = pixel_in_focus(ui);
    if (!pixel) return std::nullopt;
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    const float depth = stored_depth(framebuffer, pixel->x, pixel->y);
    return is_depth(depth, framebuffer.rules.depth_kind) ? std::optional(depth) : std::nullopt;
}

void draw_numbers(Ui& ui, const DepthView& view, ImVec2 low, float right) {
    const Palette& p = palette(ui.options.theme);
    const float gap = 14.0f * ui.options.text_scale;
    const char* const fit = "autofit";
    const float button_left = right - button_width(fit);
    // Both ends in the same form, so that they can be compared.
    const std::vector<std::string> fars = depth_forms(ui, "far", view.range.far);
    const std::vector<std::string> nears = depth_forms(ui, "near", view.range.near);
    const float room = button_left - low.x - 2.0f * gap;
    const std::size_t form = text_width(fars[0]) + text_width(nears[0]) <= room ? 0 : 1;
    const std::string &far = fars[form], &near = nears[form];
    const float y = low.y + ImGui::GetStyle().FramePadding.y;
    ImGui::SetCursorScreenPos({low.x, y});
    text_in(p.dim, far);
    register_widget(ui, "depth.far_text",
                    depth_name(ui) + " at which pixels become darkest, and its z: " +
                        depth_text(ui, view.range.far) + ".",
                    far);
    const float far_end = ImGui::GetItemRectMax().x + gap;
    const float near_left = button_left - gap - ImGui::CalcTextSize(near.c_str()).x;
    ImGui::SetCursorScreenPos({std::max(near_left, far_end), y});
    text_in(p.dim, near);
    register_widget(ui, "depth.near_text",
                    depth_name(ui) + " at which pixels become brightest, and its z: " +
                        depth_text(ui, view.range.near) + ".",
                    near);
    if (const std::optional<float> depth = depth_in_focus(ui)) {
        const std::string here = depth_forms(ui, "here", *depth)[form];
        const float width = ImGui::CalcTextSize(here.c_str()).x;
        const float middle = 0.5f * (far_end + near_left - gap);
        if (width < near_left - gap - far_end) {
            ImGui::SetCursorScreenPos({middle - 0.5f * width, y});
            text_in(p.text, here);
        }
    }
    ImGui::SetCursorScreenPos({button_left, low.y});
    const bool is_automatic = !ui.session.depth_range;
    if (button(ui, "depth.autofit", fit, is_automatic ? Look::plain : Look::outline,
               (is_automatic ? "The range follows the picture: from the farthest to the nearest "
                             : "Lets the range follow the picture again, from the farthest to the "
                               "nearest ") +
                   depth_name(ui) + " that is stored.")) {
        ui.session.depth_range = std::nullopt;
    }
}

} // namespace

float depth_legend_height(const Ui& ui, float canvas_height) {
    if (ui.session.view != View::depth || !ui.results.depth) return 0.0f;
    const float u = ui.options.text_scale;
    const float text = ui.fonts.small->FontSize + 2.0f * ImGui::GetStyle().FramePadding.y;
    return text + 4.0f * u + bars_height_of(ui, canvas_height) + strip_height * u;
}

void draw_depth_legend(Ui& ui, ImVec2 low, ImVec2 high) {
    if (!ui.results.depth) return;
    const DepthView& view = *ui.results.depth;
    const float u = ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    draw_numbers(ui, view, low, high.x);
    const float text = ImGui::GetFontSize() + 2.0f * ImGui::GetStyle().FramePadding.y;
    const Plot plot{view, {low.x, low.y + text + 4.0f * u}, high, high.y - strip_height * u};

    ImDrawList* const list = ImGui::GetWindowDrawList();
    draw_bars(ui, list, plot);
    if (!view.present) {
        const Palette& p = palette(ui.options.theme);
        ImGui::SetCursorScreenPos({plot.low.x + 10.0f * u, plot.low.y + 3.0f * u});
        text_in(p.dim, "Nothing has a depth yet.");
    } else {
        draw_outside(ui, list, plot);
        if (const std::optional<float> depth = depth_in_focus(ui))
            draw_pointer(ui, list, plot, *depth);
        const std::optional<float> far = draw_handle(ui, plot, false);
        const std::optional<float> near = draw_handle(ui, plot, true);
        if (far) set_far(ui.session, view, *far);
        if (near) set_near(ui.session, view, *near);
    }
    ImGui::SetCursorScreenPos(plot.low);
    ImGui::Dummy({plot.high.x - plot.low.x, plot.high.y - plot.low.y});
    const bool on_handle = ImGui::IsAnyItemHovered() || ImGui::IsAnyItemActive();
    register_widget(ui, "depth.histogram",
                    on_handle ? std::string()
                              : bar_text(plot, ImGui::GetIO().MousePos.x, depth_name(ui)));
    ImGui::PopFont();
}

} // namespace rasterwalk
