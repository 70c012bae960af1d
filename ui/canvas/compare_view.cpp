#include "ui/canvas/compare_view.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/canvas/compare_titles.h"
#include "ui/canvas/overlays.h"
#include "ui/canvas/picture_view.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/picture_texture.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Width of the part of the divider that can be dragged, design pixels.
constexpr float handle_width = 18.0f;

bool is_side_by_side(const Ui& ui) {
    return is_comparing(ui) && ui.session.compare_view == CompareView::side_by_side;
}

/// The left and right end of the part of the picture that can be seen.
struct Span {
    float low, high;
};
Span visible_span(const Ui& ui, const Pane& canvas) {
    const PicturePlace& place = ui.canvas.place;
    const float width =
        place.scale * static_cast<float>(ui.results.a.frame.settings.viewport.width);
    const float low = std::max(place.origin.x, canvas.low.x);
    return {low, std::max(std::min(place.origin.x + width, canvas.high.x), low + 1.0f)};
}

/// How large the picture may get in a part of the canvas of this size.
float pane_zoom(const Ui& ui, ImVec2 room) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float border = 2.0f * picture_border * ui.options.text_scale;
    return std::min((room.x - border) / static_cast<float>(size.width),
                    (room.y - border) / static_cast<float>(size.height));
}

float divider_x(const Ui& ui, const Pane& canvas) {
    const Span span = visible_span(ui, canvas);
    return std::round(span.low + std::clamp(ui.session.wipe, 0.0f, 1.0f) * (span.high - span.low));
}

void draw_run(Ui& ui, ImDrawList* list, bool of_b, const PicturePlace& place, ImVec2 low,
              ImVec2 high) {
    if (high.x <= low.x) return;
    list->PushClipRect(low, high, true);
    draw_texture(list, of_b ? ui.compare.picture : ui.canvas.picture, place);
    if (of_b) {
        draw_canvas_marks(ui, run_b(ui, place), list, low, high);
    } else {
        draw_overlays(ui, list, low, high);
        std::vector<CanvasLabel> labels = draw_canvas_marks(ui, run_a(ui), list, low, high);
        draw_vector_marks(ui, list, low, high, labels);
    }
    list->PopClipRect();
}

void draw_divider(const Ui& ui, ImDrawList* list, const Pane& canvas) {
    const float u = ui.options.text_scale;
    const float x = divider_x(ui, canvas);
    const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 150);
    list->AddLine({x, canvas.low.y}, {x, canvas.high.y}, black, 4.0f * u);
    list->AddLine({x, canvas.low.y}, {x, canvas.high.y}, white, 2.0f * u);
    const ImVec2 middle{x, std::round(0.5f * (canvas.low.y + canvas.high.y))};
    list->AddCircleFilled(middle, 12.0f * u, black);
    list->AddCircleFilled(middle, 11.0f * u, white);
    for (const float side : {-1.0f, 1.0f}) {
        list->AddTriangleFilled({middle.x + side * 7.0f * u, middle.y},
                                {middle.x + side * 2.5f * u, middle.y - 4.0f * u},
                                {middle.x + side * 2.5f * u, middle.y + 4.0f * u},
                                IM_COL32(30, 34, 40, 255));
    }
}

void draw_side_by_side(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const Panes panes = panes_of(ui, canvas);
    const float u = ui.options.text_scale;
    draw_run(ui, list, false, ui.canvas.place, panes.a.low, panes.a.high);
    draw_run(ui, list, true, *ui.compare.place_of_b, panes.b.low, panes.b.high);
    const bool is_stacked = panes.b.low.x == panes.a.low.x;
    const float top_of_b = panes.b.low.y - (panes.a.low.y - canvas.low.y);
    const ImVec2 from = is_stacked ? ImVec2{canvas.low.x, std::round(top_of_b) - 0.5f}
                                   : ImVec2{std::round(panes.b.low.x) - 0.5f, canvas.low.y};
    const ImVec2 to = is_stacked ? ImVec2{canvas.high.x, from.y} : ImVec2{from.x, canvas.high.y};
    list->AddLine(from, to, packed(palette(ui.options.theme).line), u);
    draw_two_titles(ui, list,
                    place_of_title(ui, canvas, panes.a.low.x, panes.a.high.x, canvas.low.y),
                    place_of_title(ui, canvas, panes.b.low.x, panes.b.high.x, top_of_b));
}

void draw_wipe(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const float x = divider_x(ui, canvas);
    draw_run(ui, list, false, ui.canvas.place, canvas.low, {x, canvas.high.y});
    draw_run(ui, list, true, ui.canvas.place, {x, canvas.low.y}, canvas.high);
    draw_divider(ui, list, canvas);
    draw_both_titles(ui, list, canvas);
}

/// One run in the whole canvas.
void draw_alone(Ui& ui, ImDrawList* list, const Pane& canvas, bool of_b, bool is_at_right) {
    draw_run(ui, list, of_b, ui.canvas.place, canvas.low, canvas.high);
    TitlePlace title = place_of_title(ui, canvas, canvas.low.x, canvas.high.x, canvas.low.y);
    title.is_at_right = is_at_right;
    draw_run_title(ui, list, of_b, title);
}

void draw_blink(Ui& ui, ImDrawList* list, const Pane& canvas) {
    const bool of_b = blink_shows_b(ui);
    draw_alone(ui, list, canvas, of_b, of_b);
}

void draw_difference(Ui& ui, ImDrawList* list, const Pane& canvas) {
    draw_texture(list, ui.compare.difference, ui.canvas.place);
    draw_canvas_marks(ui, run_a(ui), list, canvas.low, canvas.high);
    draw_both_titles(ui, list, canvas);
}

void show_textures(Ui& ui, const Pane& canvas) {
    const RunResults& b = *ui.results.b;
    const ComparisonResults& comparison = ui.results.comparison;
    const PicturePlace& place = ui.canvas.place;
    const CompareView view = ui.session.compare_view;
    if (view == CompareView::difference) {
        show_texture(ui, ui.compare.difference,
                     {comparison.difference, comparison.difference_number}, place, canvas.low,
                     canvas.high);
        return;
    }
    if (view != CompareView::run_b) show_ground(ui, canvas.low, canvas.high);
    if (view != CompareView::run_a) {
        show_texture(ui, ui.compare.picture, shown_picture(b),
                     ui.compare.place_of_b.value_or(place), canvas.low, canvas.high);
    }
}

void draw_views(Ui& ui, bool as_list) {
    const CompareView chosen = ui.session.compare_view;
    if (as_list) {
        const CompareViewInfo& now = compare_view_list()[static_cast<std::size_t>(chosen)];
        ImGui::SetNextItemWidth(button_width("Side by side ") + ImGui::GetFrameHeight());
        const bool open = ImGui::BeginCombo("##compare view", now.title.data());
        register_widget(ui, "compare.view", "How the two pictures are shown.");
        if (!open) return;
        for (const CompareViewInfo& info : compare_view_list()) {
            if (list_entry(ui, std::string("compare.").append(info.name), info.menu_title,
                           info.view == chosen, info.help)) {
                ui.session.compare_view = info.view;
            }
        }
        ImGui::EndCombo();
        return;
    }
    for (const CompareViewInfo& info : compare_view_list()) {
        if (info.view != compare_view_list().front().view) ImGui::SameLine(0.0f, 0.0f);
        if (button(ui, std::string("compare.").append(info.name), info.title,
                   info.view == chosen ? Look::chosen : Look::plain, info.help)) {
            ui.session.compare_view = info.view;
        }
    }
}

/// The width of the views as buttons side by side.
float views_width() {
    float width = 0.0f;
    for (const CompareViewInfo& info : compare_view_list())
        width += button_width(info.title);
    return width;
}

/// @param title height of the titles above the pictures, screen pixels
Panes panes_below_titles(const Ui& ui, const Pane& canvas, float title) {
    Pane below = canvas;
    below.low.y += title;
    if (!is_side_by_side(ui)) return {below, below};
    Panes beside{below, below};
    beside.a.high.x = beside.b.low.x = std::round(0.5f * (canvas.low.x + canvas.high.x));
    Panes stacked{below, below};
    const float middle = std::round(0.5f * (canvas.low.y + canvas.high.y));
    stacked.a.high.y = middle;
    stacked.b.low.y = middle + title;
    const float side_zoom = pane_zoom(ui, beside.a.room());
    const float stack_zoom = pane_zoom(ui, stacked.b.room());
    const float side_whole = std::floor(side_zoom), stack_whole = std::floor(stack_zoom);
    const bool is_stacked =
        stack_whole != side_whole ? stack_whole > side_whole : stack_zoom > side_zoom;
    return is_stacked ? stacked : beside;
}

} // namespace

void draw_compare_bar(Ui& ui) {
    if (!ui.session.b) return;
    const Palette& p = palette(ui.options.theme);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(ui.fonts.small);
    const float ends = button_width("swap") + button_width("end") + gap;
    const float counts = ImGui::CalcTextSize("000 000 pixels differ").x;
    const bool as_list =
        views_width() + counts + ends + 2.0f * gap > ImGui::GetContentRegionAvail().x;
    if (is_comparing(ui)) {
        draw_views(ui, as_list);
        ImGui::SameLine();
    }
    const float left = ImGui::GetCursorScreenPos().x;
    const float room = right - ends - gap - left;
    ImGui::AlignTextToFramePadding();
    if (!is_comparing(ui)) {
        text_in(colour_of(Meaning::fail, ui.options.theme),
                shortened(ui.results.no_comparison, room));
        register_widget(ui, "compare.fault", ui.results.no_comparison);
    } else {
        std::vector<std::string> forms = difference_forms(ui.results.comparison.pixels);
        forms.emplace_back(); // the Compare tab has the numbers too
        const std::string shown = first_fitting(forms, room);
        const float width = text_width(shown);
        ImGui::SetCursorScreenPos(
            {std::max(right - ends - gap - width, left), ImGui::GetCursorScreenPos().y});
        text_in(p.dim, shown);
        register_widget(
            ui, "compare.counts",
            forms.front() +
                "\nCounted in what is drawn so far. Differences are those of the channel "
                "that differs most, in linear colour. The Compare tab has more.",
            shown);
    }
    ImGui::SameLine();
    ImGui::SetCursorScreenPos({right - ends, ImGui::GetCursorScreenPos().y});
    if (button(ui, "compare.swap", "swap", Look::quiet, tooltip_of("compare.swap"))) {
        find_action("compare.swap").run(ui);
    }
    ImGui::SameLine();
    if (button(ui, "compare.end", "end", Look::quiet, "Ends the comparison.\nKey: C"))
        toggle_compare(ui);
    ImGui::PopFont();
}

float height_at_full_size(const Ui& ui, float width) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float u = ui.options.text_scale;
    const float border = 2.0f * picture_border * u;
    const float one = static_cast<float>(size.height) + std::ceil(title_height * u) + border;
    const bool is_stacked =
        is_side_by_side(ui) && 0.5f * width - border < static_cast<float>(size.width);
    return is_stacked ? 2.0f * one : one;
}

float pair_zoom(const Ui& ui, ImVec2 canvas) {
    return pane_zoom(ui, panes_of(ui, {{0.0f, 0.0f}, canvas}).a.room());
}

Panes panes_of(const Ui& ui, const Pane& canvas) {
    if (!is_comparing(ui)) return {canvas, canvas};
    const float u = ui.options.text_scale, title = std::round(title_height * u);
    if (canvas.room().y >= low_canvas * u) return panes_below_titles(ui, canvas, title);
    // In a low canvas the titles are next to the pictures if they can be.
    const Panes whole = panes_below_titles(ui, canvas, 0.0f);
    if (has_room_for_letter(ui, whole.a.room(), pane_zoom(ui, whole.a.room()))) return whole;
    return panes_below_titles(ui, canvas, title);
}

void draw_wipe_handle(Ui& ui, const Pane& canvas) {
    if (!is_comparing(ui) || ui.session.compare_view != CompareView::wipe) return;
    const float width = handle_width * ui.options.text_scale;
    ImGui::SetCursorScreenPos({divider_x(ui, canvas) - 0.5f * width, canvas.low.y});
    ImGui::InvisibleButton("compare.wipe_handle", {width, canvas.high.y - canvas.low.y});
    const bool is_held = ImGui::IsItemActive();
    if (is_held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    register_widget(ui, "compare.divider", "A is on the left, B on the right. Drag it.");
    const auto right = static_cast<float>(take_arrows(ui, "compare.divider").right);
    ui.session.wipe = std::clamp(ui.session.wipe + 0.02f * right, 0.0f, 1.0f);
    if (!is_held) return;
    const Span span = visible_span(ui, canvas);
    const float at = (ImGui::GetIO().MousePos.x - span.low) / (span.high - span.low);
    ui.session.wipe = std::clamp(at, 0.0f, 1.0f);
}

void draw_compared(Ui& ui, ImDrawList* list, const Pane& canvas) {
    show_textures(ui, canvas);
    switch (ui.session.compare_view) {
    case CompareView::run_a:
        draw_alone(ui, list, canvas, false, false);
        break;
    case CompareView::run_b:
        draw_alone(ui, list, canvas, true, false);
        break;
    case CompareView::side_by_side:
        draw_side_by_side(ui, list, canvas);
        break;
    case CompareView::wipe:
        draw_wipe(ui, list, canvas);
        break;
    case CompareView::blink:
        draw_blink(ui, list, canvas);
        break;
    case CompareView::difference:
        draw_difference(ui, list, canvas);
        break;
    }
}

} // namespace rasterwalk
