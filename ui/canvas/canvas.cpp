#include "ui/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "settings/setting_table.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/outside.h"
#include "ui/actions/zoom.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/compare_variants.h"
#include "ui/canvas/compare_view.h"
#include "ui/canvas/depth_legend.h"
#include "ui/canvas/difference_legend.h"
#include "ui/canvas/layers.h"
#include "ui/canvas/outside_view.h"
#include "ui/canvas/overdraw_legend.h"
#include "ui/canvas/overlays.h"
#include "ui/canvas/row_table_beside.h"
#include "ui/ui.h"
#include "ui/widgets/picture_texture.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// What a picture that fits keeps of its size at least to be a whole multiple.
constexpr float share_kept = 0.95f;

/// How far the camera turns for each screen pixel of a drag, radians.
constexpr float turn_per_pixel = 0.004f;

/// Around everything in the canvas, design pixels.
constexpr glm::vec2 canvas_padding{12.0f, 10.0f};

float fit_zoom(const Ui& ui, ImVec2 room) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float zoom =
        std::min(room.x / static_cast<float>(size.width), room.y / static_cast<float>(size.height));
    // Whole multiples keep all pixels equally large and sharp: where they cost next to nothing.
    const float whole = std::floor(zoom);
    return whole >= share_kept * zoom ? whole : std::max(zoom, 0.01f);
}

/// Where the picture lies, and the row table that it leaves room for.
struct Placing {
    PicturePlace picture;
    RowTableLayout table; ///< the roomiest one; whether it is shown depends on the zoom
};

/// A picture that fits: whole, and beside the row table if its rows can be as high as the table's
/// lines then.
Placing place_whole(const Ui& ui, ImVec2 low, ImVec2 room) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const float least = row_table_zoom(ui);
    Placing placing;
    const auto centre = [&](ImVec2 in) {
        placing.picture.scale = fit_zoom(ui, in);
        placing.picture.origin = {
            std::round(low.x + 0.5f * (in.x - placing.picture.scale * width)),
            std::round(low.y + 0.5f * (in.y - placing.picture.scale * height))};
    };
    const float spare = room.x - least * width;
    if (spare > 0.0f && fit_zoom(ui, room) >= least) {
        placing.table = row_table_layout(ui, room.x, spare);
        if (placing.table.width > 0.0f) {
            centre({room.x - placing.table.width, room.y});
            if (placing.picture.scale >= least) return placing;
        }
    }
    placing.table = row_table_layout(ui, room.x);
    centre(room);
    // The table stands at the right: as little as possible of the picture lies under it.
    if (placing.table.width > 0.0f && placing.picture.scale >= least)
        placing.picture.origin.x = std::min(placing.picture.origin.x, low.x);
    return placing;
}

Placing place_picture(const Ui& ui, ImVec2 low, ImVec2 room) {
    if (ui.session.canvas.zoom <= 0.0f) return place_whole(ui, low, room);
    Placing placing{{}, row_table_layout(ui, room.x)};
    PicturePlace& place = placing.picture;
    place.scale = ui.session.canvas.zoom;
    const glm::vec2 centre = ui.session.canvas.centre;
    place.origin = {std::round(low.x + 0.5f * room.x - place.scale * centre.x),
                    std::round(low.y + 0.5f * room.y - place.scale * centre.y)};
    return placing;
}

ImVec2 picture_point(const PicturePlace& place, ImVec2 screen) {
    return {(screen.x - place.origin.x) / place.scale, (screen.y - place.origin.y) / place.scale};
}

/// Sets zoom and centre such that the picture point under the pointer stays there.
void zoom_about(Ui& ui, ImVec2 pointer, float zoom, ImVec2 low, ImVec2 room) {
    const ImVec2 fixed_point = picture_point(ui.canvas.place, pointer);
    ui.session.canvas.zoom = std::clamp(zoom, smallest_zoom, largest_zoom);
    ui.session.canvas.centre = {
        fixed_point.x - (pointer.x - low.x - 0.5f * room.x) / ui.session.canvas.zoom,
        fixed_point.y - (pointer.y - low.y - 0.5f * room.y) / ui.session.canvas.zoom};
    ui.canvas.place = place_picture(ui, low, room).picture;
}

/// The next zoom step: factors of the square root of two, whole numbers from 4x on.
float next_zoom(float zoom, float wheel) {
    const float next = zoom * std::pow(2.0f, 0.5f * wheel);
    return next >= 4.0f ? std::round(next) : next;
}

/// The pointer; over the picture of run B as if it were over the same place of run A's.
ImVec2 pointer_in_a(const Ui& ui) {
    ImVec2 pointer = ImGui::GetIO().MousePos;
    const std::optional<PicturePlace>& b = ui.compare.place_of_b;
    if (!b) return pointer;
    const WidgetPlace& canvas = ui.widgets.at("canvas");
    const ImVec2 a = ui.canvas.place.origin;
    const ImVec2 aside{b->origin.x - a.x, b->origin.y - a.y};
    const bool is_over_b = aside.x > 0.0f
                               ? pointer.x >= 0.5f * (canvas.top_left.x + canvas.bottom_right.x)
                               : pointer.y >= 0.5f * (canvas.top_left.y + canvas.bottom_right.y);
    if (is_over_b) pointer = {pointer.x - aside.x, pointer.y - aside.y};
    return pointer;
}

void handle_pointer(Ui& ui, ImVec2 low, ImVec2 room) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
    const ImVec2 pointer = pointer_in_a(ui);
    const ImVec2 at = picture_point(ui.canvas.place, pointer);
    const glm::ivec2 pixel(std::floor(at.x), std::floor(at.y));
    if (ui.results.a.framebuffer->contains(pixel.x, pixel.y)) ui.canvas.hovered_pixel = pixel;
    if (io.MouseWheel != 0.0f && ImGui::IsItemHovered()) {
        zoom_about(ui, pointer, next_zoom(ui.canvas.place.scale, io.MouseWheel), low, room);
    }
    if (ImGui::IsMouseDoubleClicked(0)) {
        ui.session.canvas.zoom = 0.0f;
        return;
    }
    if (drag_bench_vertex(ui)) return;
    const bool has_moved =
        io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    if (ImGui::IsMouseReleased(0) && !has_moved && ui.canvas.hovered_pixel) {
        pick_on_picture(ui, *ui.canvas.hovered_pixel, io.KeyShift);
    }
    if (ImGui::IsMouseDragging(0) && (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f)) {
        if (ui.session.canvas.zoom <= 0.0f) {
            zoom_about(ui, pointer, ui.canvas.place.scale, low, room);
        }
        ui.session.canvas.centre.x -= io.MouseDelta.x / ui.session.canvas.zoom;
        ui.session.canvas.centre.y -= io.MouseDelta.y / ui.session.canvas.zoom;
        ui.canvas.place = place_picture(ui, low, room).picture;
    }
    if (ImGui::IsMouseDragging(1)) turn_camera(ui, io.MouseDelta);
}

/// The width of what says what the canvas shows.
float shows_width(bool as_list) {
    if (as_list) return button_width("Outside ") + ImGui::GetFrameHeight();
    float width = 0.0f;
    for (const CanvasShowsInfo& info : canvas_shows_list())
        width += button_width(info.title);
    return width;
}

float view_selector_width() {
    return button_width("triangle  ") + ImGui::GetFrameHeight();
}

void draw_view_selector(Ui& ui) {
    ImGui::SetNextItemWidth(view_selector_width());
    const bool open = ImGui::BeginCombo(
        "##view", view_list()[static_cast<std::size_t>(ui.session.view)].title.data());
    name_widget(ui, "canvas.view", "Which plane of the framebuffer is shown.");
    if (!open) return;
    for (const ViewInfo& info : view_list()) {
        if (ImGui::Selectable(info.title.data(), info.view == ui.session.view)) {
            ui.session.view = info.view;
        }
        name_widget(ui, std::string("canvas.view.").append(info.title), info.help);
    }
    ImGui::EndCombo();
}

/// What the canvas shows, as buttons side by side or as a list.
void draw_shows_switch(Ui& ui, bool as_list) {
    const CanvasShows chosen = shown_on_canvas(ui);
    const auto& list = canvas_shows_list();
    if (as_list) {
        const char* const title = list[static_cast<std::size_t>(chosen)].title.data();
        ImGui::SetNextItemWidth(shows_width(true));
        const bool open = ImGui::BeginCombo("##shows", title);
        name_widget(ui, "canvas.shows", "What the canvas shows.");
        if (!open) return;
        for (const CanvasShowsInfo& info : list) {
            if (ImGui::Selectable(info.title.data(), info.shows == chosen))
                show_on_canvas(ui, info.shows);
            name_widget(ui, std::string("canvas.shows.").append(info.name), info.help);
        }
        ImGui::EndCombo();
        return;
    }
    for (const CanvasShowsInfo& info : list) {
        if (info.shows != CanvasShows::picture) ImGui::SameLine(0.0f, 0.0f);
        const std::string action = std::string("view.show_").append(info.name);
        if (button(ui, std::string("canvas.shows.").append(info.name), info.title,
                   info.shows == chosen ? Look::chosen : Look::plain, tooltip_of(action))) {
            show_on_canvas(ui, info.shows);
        }
    }
}

bool fits(const Ui& ui) {
    const OutsideView& outside = ui.session.canvas.outside;
    const bool picture = ui.session.canvas.zoom <= 0.0f;
    const bool all = outside.distance <= 0.0f && !outside.is_camera;
    switch (shown_on_canvas(ui)) {
    case CanvasShows::picture:
        return picture;
    case CanvasShows::outside:
        return all;
    case CanvasShows::both:
        return picture && all;
    }
    return picture;
}

/// A button at the right end of the header.
struct HeaderButton {
    const char *name, *label, *action;
    bool is_on;
};

/// Does a widget of this name stand in the header?
bool is_in_header(std::string_view widget) {
    constexpr std::string_view beginnings[] = {"canvas.view", "canvas.shows", "canvas.fit",
                                               "canvas.zoom", "canvas.grid",  "canvas.overlays"};
    return std::any_of(std::begin(beginnings), std::end(beginnings),
                       [&](std::string_view beginning) { return widget.starts_with(beginning); });
}

void draw_header(Ui& ui, float right_edge) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const CanvasShows shows = shown_on_canvas(ui);
    const bool has_picture = shows != CanvasShows::outside;
    std::vector<HeaderButton> buttons{{"canvas.fit", "fit", "view.fit", fits(ui)}};
    if (has_picture) {
        buttons.push_back({"canvas.zoom_triangle", "triangle", "view.zoom_selection", false});
        buttons.push_back({"canvas.grid", "grid", "view.grid", ui.session.canvas.grid});
    }
    const auto width_of_buttons = [&] {
        float width = -gap;
        for (const HeaderButton& b : buttons)
            width += button_width(b.label) + gap;
        return width;
    };
    const float left = ImGui::GetCursorScreenPos().x;
    const float planes =
        has_picture ? view_selector_width() + layers_button_width(ui, true) + 2.0f * gap : 0.0f;
    const float room = right_edge - left - planes - gap;
    const bool has_switch = ui.session.scene->space == SceneSpace::world;
    const bool as_list = has_switch && shows_width(false) > room - width_of_buttons();
    const float before = has_switch ? shows_width(as_list) : 0.0f;
    // What has no room stands in the View menu.
    while (buttons.size() > 1 && before > room - width_of_buttons())
        buttons.pop_back();
    if (has_switch) {
        draw_shows_switch(ui, as_list);
        ImGui::SameLine();
    }
    const float start = right_edge - width_of_buttons();
    if (has_picture) {
        draw_view_selector(ui);
        ImGui::SameLine();
        const float rest = start - gap - ImGui::GetCursorScreenPos().x;
        draw_layers_button(ui, layers_button_width(ui, false) > rest);
        ImGui::SameLine();
        const float scale = ui.canvas.place.scale;
        const std::string zoom =
            decimals(static_cast<double>(scale), scale == std::round(scale) ? 0 : 2) + "x";
        const float label = ImGui::CalcTextSize("00.00x").x + gap;
        if (start - label > ImGui::GetCursorScreenPos().x) {
            ImGui::SetCursorScreenPos({start - label, ImGui::GetCursorScreenPos().y});
            ImGui::AlignTextToFramePadding();
            text_in(palette(ui.options.theme).dim, zoom);
            ImGui::SameLine();
        }
    }
    ImGui::SetCursorScreenPos(
        {std::max(start, ImGui::GetCursorScreenPos().x), ImGui::GetCursorScreenPos().y});
    for (const HeaderButton& b : buttons) {
        if (&b != buttons.data()) ImGui::SameLine();
        if (button(ui, b.name, b.label, b.is_on ? Look::plain : Look::quiet,
                   tooltip_of(b.action))) {
            find_action(b.action).run(ui);
        }
    }
}

/// Where the pictures of both runs lie; that of B only while it stands beside or below A's.
/// @return the row table beside them
RowTableLayout place_pictures(Ui& ui, ImVec2 low, ImVec2 room, const Panes& panes) {
    const Placing placing = place_picture(ui, low, room);
    ui.canvas.place = placing.picture;
    ui.compare.place_of_b = std::nullopt;
    const ImVec2 aside{panes.b.low.x - panes.a.low.x, panes.b.low.y - panes.a.low.y};
    if (aside.x > 0.0f || aside.y > 0.0f) {
        ui.compare.place_of_b = ui.canvas.place;
        ui.compare.place_of_b->origin.x += aside.x;
        ui.compare.place_of_b->origin.y += aside.y;
    }
    return placing.table;
}

/// What of the canvas is left of the picture beside the row table.
Pane beside_table(const Ui& ui, const Pane& canvas) {
    const std::optional<RowTablePlace>& table = ui.canvas.row_table;
    if (!table) return canvas;
    Pane seen = canvas;
    if (table->is_at_left) {
        seen.low.x = std::min(table->right, canvas.high.x);
    } else {
        seen.high.x = std::max(table->left, canvas.low.x);
    }
    return seen;
}

/// Space around a picture that fits: for the numbers if it is enlarged, or else only a little.
float border_width(const Ui& ui, ImVec2 room) {
    const float u = ui.options.text_scale;
    const bool numbered = fit_zoom(ui, {room.x - 2.0f * canvas_ruler * u,
                                        room.y - 2.0f * canvas_ruler * u}) >= grid_zoom;
    return (numbered ? canvas_ruler : picture_border) * u;
}

/// Between the picture and what stands below it, screen pixels.
float gap_below(const Ui& ui) {
    return std::round(8.0f * ui.options.text_scale);
}

/// The room that two pictures have in a canvas of this size: without the lines above them, and the
/// small pictures below.
ImVec2 room_of_pictures(const Ui& ui, ImVec2 canvas) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float u = ui.options.text_scale;
    const float header = ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float bar = ui.fonts.small->FontSize + 2.0f * style.FramePadding.y + style.ItemSpacing.y;
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
    const float above_row = space.y - legend - legend_gap - gap_below(ui);
    const float row = variants_height(ui, {space.x, above_row});
    const float below = legend + legend_gap + (row > 0.0f ? row + gap_below(ui) : 0.0f);
    const ImVec2 frame_room{std::max(space.x, 1.0f), std::max(space.y - below, 1.0f)};
    const ImVec2 frame_high{frame_low.x + frame_room.x, frame_low.y + frame_room.y};
    const Pane canvas{frame_low, frame_high};
    const Panes panes = panes_of(ui, canvas);
    const float border = border_width(ui, panes.a.room());
    const ImVec2 low{panes.a.low.x + border, panes.a.low.y + border};
    const ImVec2 room{std::max(panes.a.room().x - 2.0f * border, 1.0f),
                      std::max(panes.a.room().y - 2.0f * border, 1.0f)};
    place_pictures(ui, low, room, panes);
    draw_wipe_handle(ui, canvas);
    ImGui::SetCursorScreenPos(frame_low);
    ImGui::InvisibleButton("picture", frame_room,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    name_widget(ui, "canvas");
    handle_pointer(ui, low, room);
    const RowTableLayout table = place_pictures(ui, low, room, panes);
    ui.canvas.row_table = place_row_table(ui, table, canvas);
    const Pane seen = beside_table(ui, canvas);

    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(frame_low, frame_high, packed(p.canvas), 4.0f * u);
    list->PushClipRect(seen.low, seen.high, true);
    if (is_comparing(ui)) {
        draw_compared(ui, list, canvas);
    } else {
        show_ground(ui, seen.low, seen.high);
        draw_texture(list, ui.canvas.picture, ui.canvas.place);
        draw_overlays(ui, list, seen.low, seen.high);
        draw_canvas_marks(ui, run_a(ui), list, seen.low, seen.high);
    }
    list->PopClipRect();
    if (!is_comparing(ui)) draw_cells(ui, seen);
    if (ui.canvas.row_table) {
        const bool is_over = draw_row_table_beside(ui, table, *ui.canvas.row_table, canvas);
        const ImGuiIO& io = ImGui::GetIO();
        if (is_over && io.MouseWheel != 0.0f)
            zoom_about(ui, io.MousePos, next_zoom(ui.canvas.place.scale, io.MouseWheel), low, room);
    }
    list->AddRect(frame_low, frame_high, packed(p.line), 4.0f * u);
    draw_overlay_legend(ui, {std::max(seen.low.x, panes.a.low.x), panes.a.low.y},
                        {std::min(seen.high.x, panes.a.high.x), panes.a.high.y});
    const float legend_top = frame_high.y + legend_gap;
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
    if (shows == CanvasShows::both) return true;
    if (!is_comparing(ui) || ui.session.compare_view != CompareView::side_by_side ||
        shows == CanvasShows::outside) {
        return false;
    }
    const float zoom = pair_zoom(ui, room_of_pictures(ui, narrow));
    return zoom < 1.0f && pair_zoom(ui, room_of_pictures(ui, wide)) > zoom;
}

void pick_on_picture(Ui& ui, glm::ivec2 pixel, bool triangle_only) {
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    Selection& selection = ui.session.selection;
    if (!framebuffer.contains(pixel.x, pixel.y)) return;
    const int owner = framebuffer.owner[framebuffer.at(pixel.x, pixel.y)];
    if (owner >= 0) selection.triangle = owner;
    if (triangle_only) return;
    selection.pixel = pixel;
    selection.row = pixel.y;
}

void turn_camera(Ui& ui, ImVec2 by) {
    Camera& camera = ui.session.a.settings.camera;
    camera.yaw += turn_per_pixel * by.x;
    camera.pitch -= turn_per_pixel * by.y;
    clamp_to_ranges(ui.session.a.settings);
}

void draw_canvas(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(canvas_padding.x * u, canvas_padding.y * u));
    ImGui::Begin("canvas", nullptr,
                 panel_flags | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
    // In a lecture only when it points there: the menus have what stands in the header.
    if (!ui.options.is_lecture || is_in_header(ui.lesson.pointed_at)) {
        draw_header(ui, area.position.x + area.size.x - canvas_padding.x * u);
    }

    draw_compare_bar(ui);

    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const Pane all{low, {low.x + std::max(space.x, 1.0f), low.y + std::max(space.y, 1.0f)}};
    const CanvasShows shows = shown_on_canvas(ui);
    const CanvasHalves halves =
        shows == CanvasShows::both ? canvas_halves(ui, all) : CanvasHalves{all, all};
    ui.canvas.hovered_pixel = std::nullopt;
    ui.canvas.hovered_row = std::nullopt;
    if (shows != CanvasShows::outside) draw_picture(ui, halves.picture);
    if (shows != CanvasShows::picture) draw_outside(ui, halves.outside);
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace rasterwalk
