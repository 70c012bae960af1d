#include "ui/canvas/canvas_pointer.h"

#include <cmath>

#include "settings/setting_table.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// How far the camera turns for each screen pixel of a drag, radians.
constexpr float turn_per_pixel = 0.004f;

/// The pointer; over run B's picture, as if it were over the same position in run A's.
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

} // namespace

void handle_canvas_pointer(Ui& ui, const Pane& pane) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
    const ImVec2 pointer = pointer_in_a(ui);
    const ImVec2 at = picture_point(ui.canvas.place, pointer);
    const glm::ivec2 pixel(std::floor(at.x), std::floor(at.y));
    if (ui.results.a.framebuffer->contains(pixel.x, pixel.y)) ui.canvas.hovered_pixel = pixel;
    if (io.MouseWheel != 0.0f && ImGui::IsItemHovered())
        zoom_by_wheel(ui, pointer, io.MouseWheel, pane);
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
    if (ImGui::IsMouseDragging(0) && (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f))
        move_picture(ui, io.MouseDelta, pane);
    if (ImGui::IsMouseDragging(1)) turn_camera(ui, io.MouseDelta);
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

} // namespace rasterwalk
