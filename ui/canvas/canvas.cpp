#include "ui/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ui/actions/compare.h"
#include "ui/actions/outside.h"
#include "ui/actions/picture_fit.h"
#include "ui/canvas/canvas_header.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/canvas/canvas_pointer.h"
#include "ui/canvas/cell_key.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/compare_variants.h"
#include "ui/canvas/compare_view.h"
#include "ui/canvas/decision_marks.h"
#include "ui/canvas/depth_legend.h"
#include "ui/canvas/difference_legend.h"
#include "ui/canvas/field_marks.h"
#include "ui/canvas/hint_bar.h"
#include "ui/canvas/large_frame.h"
#include "ui/canvas/outside_view.h"
#include "ui/canvas/overdraw_legend.h"
#include "ui/canvas/overlay_legend.h"
#include "ui/canvas/overlays.h"
#include "ui/canvas/pass_title.h"
#include "ui/canvas/picture_view.h"
#include "ui/canvas/side_row_table.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/picture_texture.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What keys do while the picture has the keyboard: the arrows pick the next pixel, plus and minus
/// zoom about the picked one.
/// @param pane of the picture of run A
/// @param seen the part of it that nothing covers: the picked pixel is brought there
void handle_canvas_keys(Ui& ui, const Pane& pane, const Pane& visible) {
    const Arrows arrows = take_arrows(ui, "canvas");
    if (!ui.focus.is_shown || ui.focus.name != "canvas") return;
    const Viewport& size = ui.results.a.frame.settings.viewport;
    const bool is_arrow = arrows.right != 0 || arrows.up != 0;
    const int zoom_steps =
        (is_key_pressed(key::equal, true) ? 1 : 0) - (is_key_pressed(key::minus, true) ? 1 : 0);
    if (!is_arrow && (zoom_steps == 0 || ImGui::GetIO().KeyCtrl)) return;
    const std::optional<glm::ivec2> picked = ui.session.selection.pixel;
    glm::ivec2 pixel = picked.value_or(glm::ivec2(size.width / 2, size.height / 2));
    if (is_arrow) {
        if (picked) pixel += glm::ivec2(arrows.right, -arrows.up);
        pixel = {std::clamp(pixel.x, 0, size.width - 1), std::clamp(pixel.y, 0, size.height - 1)};
        pick_on_picture(ui, pixel, false);
    }
    if (zoom_steps != 0) {
        zoom_by_wheel(ui, ui.canvas.place.middle_of(pixel), static_cast<float>(zoom_steps), pane);
    }
    const ImVec2 at = ui.canvas.place.middle_of(pixel);
    const bool is_seen = at.x >= visible.low.x && at.y >= visible.low.y && at.x < visible.high.x &&
                         at.y < visible.high.y;
    if (is_seen) return;
    const ImVec2 middle{0.5f * (visible.low.x + visible.high.x),
                        0.5f * (visible.low.y + visible.high.y)};
    move_picture(ui, {middle.x - at.x, middle.y - at.y}, pane);
}

/// Around picture and outside where both are shown, design pixels.
constexpr float pane_margin = 40.0f;
constexpr float least_outside = 440.0f; ///< width of the outside view, design pixels

/// Around everything in the canvas, design pixels.
constexpr glm::vec2 canvas_padding{12.0f, 10.0f};

/// The part of the canvas left for the picture, next to the row table and above the line that
/// explains the cells.
Pane visible_canvas(const Ui& ui, const Pane& canvas) {
    const std::optional<RowTablePlace>& table = ui.canvas.row_table;
    Pane visible = canvas;
    if (shows_cell_key(ui)) visible.high.y -= cell_key_height(ui);
    if (!table) return visible;
    if (table->is_at_left) {
        visible.low.x = std::min(table->right, canvas.high.x);
    } else {
        visible.high.x = std::max(table->left, canvas.low.x);
    }
    return visible;
}

/// The part of run A's picture that is seen, without the numbers along its sides.
Pane visible_picture(const Ui& ui, const Pane& pane, const Pane& canvas) {
    Pane visible = visible_canvas(ui, canvas);
    visible.low = {std::max(visible.low.x, pane.low.x), std::max(visible.low.y, pane.low.y)};
    visible.high = {std::min(visible.high.x, pane.high.x), std::min(visible.high.y, pane.high.y)};
    if (ui.canvas.place.scale < grid_zoom) return visible;
    const ImVec2 ruler = ruler_size(ui);
    return {{visible.low.x + ruler.x, visible.low.y + ruler.y}, visible.high};
}

/// Between the picture and what is below it, screen pixels.
float gap_below(const Ui& ui) {
    return std::round(8.0f * ui.options.text_scale);
}

/// The line above the pictures that are compared, screen pixels.
float compare_bar_height(const Ui& ui) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ui.fonts.small->FontSize + 2.0f * style.FramePadding.y + style.ItemSpacing.y;
}

/// The room that two pictures have in a canvas of this size: without the lines above them, and the
/// small pictures below.
ImVec2 room_of_pictures(const Ui& ui, ImVec2 canvas) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float u = ui.options.text_scale;
    const float header = ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float bar = compare_bar_height(ui);
    const ImVec2 room{std::max(canvas.x - 2.0f * canvas_padding.x * u, 1.0f),
                      std::max(canvas.y - 2.0f * canvas_padding.y * u - header - bar, 1.0f)};
    const float row = variants_height(ui, room);
    return {room.x, row > 0.0f ? room.y - row - gap_below(ui) : room.y};
}

/// The picture in a part of the canvas, with the legend of what it shows below it.
void draw_picture(Ui& ui, const Pane& pane) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const ImVec2 space = pane.room();
    const ImVec2 frame_low = pane.low;
    const float difference = difference_legend_height(ui, space.y);
    const float depth = depth_legend_height(ui, space.y);
    const float overdraw = overdraw_legend_height(ui);
    const float legend = difference > 0.0f ? difference : std::max(depth, overdraw);
    const float legend_gap = legend > 0.0f ? gap_below(ui) : 0.0f;
    const float overlays = overlay_legend_height(ui, space);
    const float overlays_gap = overlays > 0.0f ? gap_below(ui) : 0.0f;
    const float legends = legend + legend_gap + overlays + overlays_gap;
    const float above_row = space.y - legends - gap_below(ui);
    const float row = variants_height(ui, {space.x, above_row});
    const float bar = is_comparing(ui) ? 0.0f : compare_bar_height(ui);
    ui.compare.has_small = has_room_for_variants(ui, above_row - bar);
    const float below = legends + (row > 0.0f ? row + gap_below(ui) : 0.0f);
    const ImVec2 frame_room{std::max(space.x, 1.0f), std::max(space.y - below, 1.0f)};
    const ImVec2 frame_high{frame_low.x + frame_room.x, frame_low.y + frame_room.y};
    const Pane canvas{frame_low, frame_high};
    ui.canvas.frame_top = frame_low.y;
    ui.canvas.frame_bottom = frame_high.y;
    const Panes panes = panes_of(ui, canvas);
    std::vector<RowTableLayout> tables = place_pictures(ui, panes);
    draw_wipe_handle(ui, canvas);
    ImGui::SetCursorScreenPos(frame_low);
    ImGui::InvisibleButton("picture", frame_room,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    register_widget(ui, "canvas");
    const CanvasView before = ui.session.canvas;
    const int held_before = ui.canvas.dragged_vertex;
    handle_canvas_pointer(ui, panes.a);
    handle_canvas_keys(ui, panes.a, visible_picture(ui, panes.a, canvas));
    if (ui.session.canvas != before || ui.canvas.dragged_vertex != held_before)
        tables = place_pictures(ui, panes);
    const std::optional<SideRowTable> table = place_row_table(ui, tables, canvas);
    ui.canvas.row_table = table ? std::optional(table->place) : std::nullopt;
    const Pane visible = visible_canvas(ui, canvas);

    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(frame_low, frame_high, packed(p.canvas), 4.0f * u);
    std::vector<CanvasLabel> labels;
    list->PushClipRect(visible.low, visible.high, true);
    if (is_comparing(ui)) {
        draw_compared(ui, list, canvas);
    } else {
        show_ground(ui, visible.low, visible.high);
        draw_texture(list, ui.canvas.picture, ui.canvas.place);
        draw_overlays(ui, list, visible.low, visible.high);
        labels = draw_canvas_marks(ui, run_a(ui), list, visible.low, visible.high);
        draw_vector_marks(ui, list, visible.low, visible.high, labels);
    }
    list->PopClipRect();
    if (!is_comparing(ui)) {
        draw_cells(ui, visible, labels);
        const Pane seen = visible_picture(ui, panes.a, canvas);
        draw_figure_numbers(ui, list, seen, labels);
        draw_decisions(ui, list, seen, labels);
    }
    if (!is_comparing(ui)) draw_pass_title(ui, list, canvas);
    if (shows_cell_key(ui))
        draw_cell_key(ui, {{visible.low.x, visible.high.y}, {visible.high.x, canvas.high.y}});
    if (table) {
        const bool is_over = draw_side_row_table(ui, *table, canvas);
        const ImGuiIO& io = ImGui::GetIO();
        if (is_over && io.MouseWheel != 0.0f)
            zoom_by_wheel(ui, io.MousePos, io.MouseWheel, panes.a);
    }
    list->AddRect(frame_low, frame_high, packed(p.line), 4.0f * u);
    const float overlays_top = frame_high.y + overlays_gap;
    if (overlays > 0.0f) {
        draw_overlay_legend(ui, space, {frame_low.x, overlays_top},
                            {frame_high.x, overlays_top + overlays});
    }
    const float legend_top = overlays_top + overlays + legend_gap;
    if (difference > 0.0f) {
        draw_difference_legend(ui, {frame_low.x, legend_top}, {frame_high.x, legend_top + legend});
    } else if (depth > 0.0f) {
        draw_depth_legend(ui, {frame_low.x, legend_top}, {frame_high.x, legend_top + legend});
    } else if (overdraw > 0.0f) {
        draw_overdraw_legend(ui, {frame_low.x, legend_top}, {frame_high.x, legend_top + legend});
    }
    if (row > 0.0f) draw_variants(ui, {{pane.low.x, pane.high.y - row}, pane.high});
}

} // namespace

bool wants_wide_canvas(const Ui& ui, ImVec2 narrow, ImVec2 wide) {
    const CanvasShows shows = shown_on_canvas(ui);
    // The lesson stays where it is read if each pixel of the picture still has one of the screen,
    // and the names outside have room.
    if (shows == CanvasShows::both) {
        const float u = ui.options.text_scale;
        const auto picture = static_cast<float>(ui.session.a.settings.viewport.width);
        return narrow.x < 2.0f * std::max(picture + pane_margin * u, least_outside * u);
    }
    if (!is_comparing(ui) || ui.session.compare_view != CompareView::side_by_side ||
        shows == CanvasShows::outside) {
        return false;
    }
    const float zoom = pair_zoom(ui, room_of_pictures(ui, narrow));
    return zoom < 1.0f && pair_zoom(ui, room_of_pictures(ui, wide)) > zoom;
}

void draw_canvas(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(canvas_padding.x * u, canvas_padding.y * u));
    ImGui::Begin("canvas", nullptr,
                 panel_flags | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
    // In a lecture only when it points there: the menus have everything in the header.
    if (!ui.options.is_lecture || is_in_canvas_header(ui.lesson.pointed_at)) {
        draw_canvas_header(ui, area.position.x + area.size.x - canvas_padding.x * u);
    }

    draw_compare_bar(ui);
    if (!draw_large_frame_bar(ui) && shown_on_canvas(ui) != CanvasShows::outside) draw_hint_bar(ui);

    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const Pane all{low, {low.x + std::max(space.x, 1.0f), low.y + std::max(space.y, 1.0f)}};
    const CanvasShows shows = shown_on_canvas(ui);
    const CanvasHalves halves =
        shows == CanvasShows::both ? canvas_halves(ui, all) : CanvasHalves{all, all};
    ui.canvas.hovered_pixel = std::nullopt;
    ui.canvas.hovered_row = std::nullopt;
    if (shows != CanvasShows::outside) draw_picture(ui, halves.picture);
    if (shows != CanvasShows::picture) {
        draw_outside(ui, halves.outside);
    } else {
        leave_outside(ui);
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace rasterwalk
