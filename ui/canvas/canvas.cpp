#include "ui/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/numbers.h"
#include "picture/view_image.h"
#include "settings/setting_table.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/zoom.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/canvas/compare_view.h"
#include "ui/canvas/depth_legend.h"
#include "ui/canvas/difference_legend.h"
#include "ui/canvas/overlays.h"
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

float fit_zoom(const Ui& ui, ImVec2 room) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const float zoom =
        std::min(room.x / static_cast<float>(size.width), room.y / static_cast<float>(size.height));
    // Whole multiples keep all pixels equally large and sharp: where they cost next to nothing.
    const float whole = std::floor(zoom);
    return whole >= share_kept * zoom ? whole : std::max(zoom, 0.01f);
}

PicturePlace place_picture(const Ui& ui, ImVec2 low, ImVec2 room) {
    const Viewport size = ui.results.a.frame.settings.viewport;
    const bool fits = ui.session.canvas.zoom <= 0.0f;
    PicturePlace place;
    place.scale = fits ? fit_zoom(ui, room) : ui.session.canvas.zoom;
    const glm::vec2 centre = fits ? glm::vec2(0.5f * static_cast<float>(size.width),
                                              0.5f * static_cast<float>(size.height))
                                  : ui.session.canvas.centre;
    place.origin = {std::round(low.x + 0.5f * room.x - place.scale * centre.x),
                    std::round(low.y + 0.5f * room.y - place.scale * centre.y)};
    return place;
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
    ui.canvas.place = place_picture(ui, low, room);
}

/// The next zoom step: factors of the square root of two, whole numbers from 4x on.
float next_zoom(float zoom, float wheel) {
    const float next = zoom * std::pow(2.0f, 0.5f * wheel);
    return next >= 4.0f ? std::round(next) : next;
}

void pick(Ui& ui, glm::ivec2 pixel, bool triangle_only) {
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    Selection& selection = ui.session.selection;
    if (!framebuffer.contains(pixel.x, pixel.y)) return;
    const int owner = framebuffer.owner[framebuffer.at(pixel.x, pixel.y)];
    if (owner >= 0) selection.triangle = owner;
    if (triangle_only) return;
    selection.pixel = pixel;
    selection.row = pixel.y;
}

/// The pointer; over the picture of run B as if it were over the same place of run A's.
ImVec2 pointer_in_a(const Ui& ui) {
    ImVec2 pointer = ImGui::GetIO().MousePos;
    const std::optional<PicturePlace>& b = ui.compare.place_of_b;
    if (!b) return pointer;
    const WidgetPlace& canvas = ui.widgets.at("canvas");
    const float middle = 0.5f * (canvas.top_left.x + canvas.bottom_right.x);
    if (pointer.x >= middle) pointer.x -= b->origin.x - ui.canvas.place.origin.x;
    return pointer;
}

void handle_pointer(Ui& ui, ImVec2 low, ImVec2 room) {
    const ImGuiIO& io = ImGui::GetIO();
    ui.canvas.hovered_pixel = std::nullopt;
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
        pick(ui, *ui.canvas.hovered_pixel, io.KeyShift);
    }
    if (ImGui::IsMouseDragging(0) && (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f)) {
        if (ui.session.canvas.zoom <= 0.0f) {
            zoom_about(ui, pointer, ui.canvas.place.scale, low, room);
        }
        ui.session.canvas.centre.x -= io.MouseDelta.x / ui.session.canvas.zoom;
        ui.session.canvas.centre.y -= io.MouseDelta.y / ui.session.canvas.zoom;
        ui.canvas.place = place_picture(ui, low, room);
    }
    if (ImGui::IsMouseDragging(1)) {
        Camera& camera = ui.session.a.settings.camera;
        camera.yaw += turn_per_pixel * io.MouseDelta.x;
        camera.pitch -= turn_per_pixel * io.MouseDelta.y;
        clamp_to_ranges(ui.session.a.settings);
    }
}

void draw_view_selector(Ui& ui) {
    ImGui::SetNextItemWidth(button_width("triangle  ") + ImGui::GetFrameHeight());
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

void draw_header(Ui& ui, float right_edge) {
    draw_view_selector(ui);
    const float scale = ui.canvas.place.scale;
    const std::string zoom =
        decimals(static_cast<double>(scale), scale == std::round(scale) ? 0 : 2) + "x";
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float buttons =
        button_width("fit") + button_width("grid") + button_width("triangle") + 2.0f * gap;
    const float start = right_edge - buttons;
    const float label = ImGui::CalcTextSize("00.00x").x + gap;
    ImGui::SameLine();
    const float room = start - gap - ImGui::GetCursorScreenPos().x;
    draw_overlay_button(ui, overlay_button_width(ui, false) > room);
    ImGui::SameLine();
    if (start - label > ImGui::GetCursorScreenPos().x) {
        ImGui::SetCursorScreenPos({start - label, ImGui::GetCursorScreenPos().y});
        ImGui::AlignTextToFramePadding();
        text_in(palette(ui.options.theme).dim, zoom);
        ImGui::SameLine();
    }
    ImGui::SetCursorScreenPos(
        {std::max(start, ImGui::GetCursorScreenPos().x), ImGui::GetCursorScreenPos().y});
    const bool fits = ui.session.canvas.zoom <= 0.0f;
    if (button(ui, "canvas.fit", "fit", fits ? Look::plain : Look::quiet, tooltip_of("view.fit"))) {
        ui.session.canvas.zoom = 0.0f;
    }
    ImGui::SameLine();
    if (button(ui, "canvas.zoom_triangle", "triangle", Look::quiet,
               tooltip_of("view.zoom_selection"))) {
        zoom_to_triangle(ui);
    }
    ImGui::SameLine();
    if (button(ui, "canvas.grid", "grid", ui.session.canvas.grid ? Look::plain : Look::quiet,
               tooltip_of("view.grid"))) {
        ui.session.canvas.grid = !ui.session.canvas.grid;
    }
}

/// Where the pictures of both runs lie; that of B only while it stands beside A's.
void place_pictures(Ui& ui, ImVec2 low, ImVec2 room, const Panes& panes) {
    ui.canvas.place = place_picture(ui, low, room);
    ui.compare.place_of_b = std::nullopt;
    const float aside = panes.b.low.x - panes.a.low.x;
    if (aside <= 0.0f) return;
    ui.compare.place_of_b = ui.canvas.place;
    ui.compare.place_of_b->origin.x += aside;
}

/// Space around a picture that fits: for the numbers if it is enlarged, or else only a little.
float border_width(const Ui& ui, ImVec2 room) {
    const float u = ui.options.text_scale;
    const bool numbered = fit_zoom(ui, {room.x - 2.0f * canvas_ruler * u,
                                        room.y - 2.0f * canvas_ruler * u}) >= grid_zoom;
    return (numbered ? canvas_ruler : 10.0f) * u;
}

} // namespace

void draw_canvas(Ui& ui, const Area& area) {
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12.0f * u, 10.0f * u));
    ImGui::Begin("canvas", nullptr,
                 panel_flags | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
    draw_header(ui, area.position.x + area.size.x - 12.0f * u);

    draw_compare_bar(ui);

    const ImVec2 frame_low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    const float difference = difference_legend_height(ui, space.y);
    const float legend = difference > 0.0f ? difference : depth_legend_height(ui, space.y);
    const float legend_gap = legend > 0.0f ? 8.0f * u : 0.0f;
    const ImVec2 frame_room{std::max(space.x, 1.0f), std::max(space.y - legend - legend_gap, 1.0f)};
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
    place_pictures(ui, low, room, panes);

    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(frame_low, frame_high, packed(p.canvas), 4.0f * u);
    list->PushClipRect(frame_low, frame_high, true);
    if (is_comparing(ui)) {
        draw_compared(ui, list, canvas);
    } else {
        show_ground(ui);
        draw_texture(list, ui.canvas.picture, ui.canvas.place);
        draw_overlays(ui, list, frame_low, frame_high);
        draw_canvas_marks(ui, run_a(ui), list, frame_low, frame_high);
    }
    list->PopClipRect();
    list->AddRect(frame_low, frame_high, packed(p.line), 4.0f * u);
    draw_overlay_legend(ui, panes.a.low, panes.a.high);
    const float legend_top = frame_high.y + legend_gap;
    if (difference > 0.0f) {
        draw_difference_legend(ui, {frame_low.x, legend_top}, {frame_high.x, legend_top + legend});
    } else if (legend > 0.0f) {
        draw_depth_legend(ui, {frame_low.x, legend_top}, {frame_high.x, legend_top + legend});
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace rasterwalk
