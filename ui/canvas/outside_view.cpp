#include "ui/canvas/outside_view.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "base/element_names.h"
#include "inspect/cut_corners.h"
#include "outside/outside_drawing.h"
#include "session/outside_reports.h"
#include "ui/actions/actions.h"
#include "ui/actions/outside.h"
#include "ui/canvas/canvas_pointer.h"
#include "ui/canvas/outside_marks_view.h"
#include "ui/canvas/vector_marks.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/picture_texture.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// How far the view turns for each screen pixel of a drag, radians.
constexpr float outside_turn_per_pixel = 0.006f;

/// The share of the distance that is left after one step of the wheel.
constexpr float wheel_step = 0.88f;

/// The space around what is seen, for names and the caption: design pixels, and at most this part
/// of the smaller side.
constexpr float margin = 44.0f;
constexpr float largest_margin_share = 0.1f;

glm::vec3 rgb(const ImVec4& colour) {
    return {colour.x, colour.y, colour.z};
}

OutsideStyle style_of(const Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    OutsideStyle style;
    style.ground = rgb(p.canvas);
    style.line = glm::mix(rgb(p.canvas), rgb(p.text), 0.4f);
    const bool is_dark = ui.options.theme == Theme::dark;
    style.drawn = is_dark ? 0.42f : 0.5f;
    style.coming = is_dark ? 0.13f : 0.18f;
    style.cut_off = rgb(colour_of(Meaning::fail, ui.options.theme));
    style.cut_off_share = is_dark ? 0.3f : 0.35f;
    return style;
}

glm::ivec2 size_of(const Pane& pane) {
    const ImVec2 room = pane.room();
    return {std::max(static_cast<int>(room.x), 1), std::max(static_cast<int>(room.y), 1)};
}

OutsideLook look_of(const Ui& ui, const Pane& pane) {
    const ImVec2 room = pane.room();
    const float around =
        std::min(margin * ui.options.text_scale, largest_margin_share * std::min(room.x, room.y));
    return {ui.session.canvas.outside, size_of(pane), static_cast<double>(around), style_of(ui)};
}

/// The view with its distance and target set to what is seen now.
OutsideView settled_view(const Ui& ui, const Pane& pane) {
    const OutsideLook look = look_of(ui, pane);
    return settled(look.view, ui.canvas.outside_drawing->outside_scene(), look.size, look.margin);
}

/// A click: it picks what it would on the picture, or a triangle of the scene.
void pick_outside(Ui& ui, const OutsidePick& pick) {
    if (pick.pixel) {
        pick_on_picture(ui, *pick.pixel, ImGui::GetIO().KeyShift);
    } else if (pick.triangle) {
        ui.session.selection.triangle = pick.triangle;
    }
}

void drag(Ui& ui, const Pane& pane, ImVec2 by) {
    OutsideView view = settled_view(ui, pane);
    if (ImGui::GetIO().KeyShift) {
        view = shifted(view, ui.canvas.outside_drawing->eye(), {by.x, by.y});
    } else {
        view = turned(view, outside_turn_per_pixel * by.x, -outside_turn_per_pixel * by.y);
    }
    ui.session.canvas.outside = view;
}

void handle_pointer(Ui& ui, const Pane& pane) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_hovered = ImGui::IsItemHovered();
    if (!is_hovered && !ImGui::IsItemActive()) return;
    const OutsideDrawing& drawing = *ui.canvas.outside_drawing;
    const OutsidePick under = drawing.at({io.MousePos.x - pane.low.x, io.MousePos.y - pane.low.y});
    if (under.pixel && ui.results.a.framebuffer->contains(under.pixel->x, under.pixel->y)) {
        ui.canvas.hovered_pixel = under.pixel;
    }
    if (is_hovered && io.MouseWheel != 0.0f) {
        ui.session.canvas.outside =
            moved_away(settled_view(ui, pane), std::pow(wheel_step, io.MouseWheel));
    }
    if (is_hovered && ImGui::IsMouseDoubleClicked(0)) {
        switch_camera_view(ui);
        return;
    }
    const bool has_moved =
        io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    if (ImGui::IsMouseReleased(0) && !has_moved) pick_outside(ui, under);
    const bool is_moving = io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f;
    if (is_moving && ImGui::IsMouseDragging(0)) drag(ui, pane, io.MouseDelta);
    if (is_moving && ImGui::IsMouseDragging(1)) turn_camera(ui, io.MouseDelta);
}

void draw_image(Ui& ui, ImDrawList* list, const Pane& pane) {
    const OutsideDrawing& drawing = *ui.canvas.outside_drawing;
    PicturePlace place;
    place.origin = pane.low;
    place.scale = static_cast<float>(drawing.pixel_size());
    show_texture(ui, ui.canvas.outside, {drawing.image(), drawing.number()}, place, pane.low,
                 pane.high);
    draw_texture(list, ui.canvas.outside, place);
}

/// Above the caption's words, design pixels.
constexpr float caption_top = 2.0f;

/// From the lower border to the words about what is still to come, and from these to the names:
/// design pixels.
constexpr float coming_border = 8.0f, coming_gap = 4.0f;

/// The height of the line with the caption, screen pixels.
float caption_height(const Ui& ui) {
    return caption_top * ui.options.text_scale + ui.fonts.small->FontSize +
           2.0f * ImGui::GetStyle().FramePadding.y;
}

/// What can be done here, and the button for looking through the camera.
void draw_caption(Ui& ui, ImDrawList* list, const Pane& pane) {
    const float u = ui.options.text_scale;
    const bool is_camera = ui.session.canvas.outside.is_camera;
    ImGui::PushFont(ui.fonts.small);
    const bool is_narrow = pane.room().x < 300.0f * u;
    const char* const label = is_camera   ? (is_narrow ? "outside" : "back outside")
                              : is_narrow ? "camera"
                                          : "look through the camera";
    const float width = ImGui::CalcTextSize(label).x + 4.0f * u;
    const float right = pane.high.x - 8.0f * u;
    const float top = pane.low.y + caption_top * u;
    ImGui::SetCursorScreenPos({right - width, top});
    if (button(ui, "outside.camera", label, Look::link, tooltip_of("view.through_camera"))) {
        switch_camera_view(ui);
    }
    const std::string hint = is_camera ? "as the camera sees it" : "drag to turn · wheel to zoom";
    std::vector<std::string> forms{hint};
    if (const std::optional<int>& triangle = ui.results.a.triangle) {
        const std::string rays = "rays of " + triangle_name(*triangle);
        const std::string short_rays = "rays of " + short_triangle_name(*triangle);
        forms = {hint + " · " + rays, hint + " · " + short_rays, rays, short_rays};
    }
    forms.emplace_back(); // the button comes first
    const float left = pane.low.x + 10.0f * u;
    const float room = right - width - 12.0f * u - left;
    list->AddText({left, top + ImGui::GetStyle().FramePadding.y},
                  packed(palette(ui.options.theme).dim), first_fitting(forms, room).c_str());
    ImGui::PopFont();
}

/// Which triangles are still to come; empty where there are none, or no room to say it.
std::string fitting_coming_words(const Ui& ui, const Pane& pane) {
    const float u = ui.options.text_scale;
    if (pane.room().y < low_canvas * u) return {};
    std::string words = coming_words(ui.results.a.frame.triangle_count(), ui.results.a.cursor);
    const bool has_room = text_width(ui.fonts.small, words) <= pane.room().x - 20.0f * u;
    return has_room ? words : std::string();
}

/// What clipping does to the triangle shown.
WorldClipping world_clipping(const Ui& ui) {
    const RunResults& a = ui.results.a;
    if (!a.inspected.clip) return {};
    return clipping_outside(a.frame, *a.inspected.clip, a.done, ui.inspector.clip.plane);
}

/// Is it seen where the division puts a vertex behind the camera? If the triangle is drawn with
/// that vertex, and while it is clipped, which saves it from that.
bool is_mirrored_visible(const RunResults& run) {
    if (!run.triangle) return false;
    if (run.inspected.clip && clip_progress(*run.inspected.clip, run.done)) return true;
    return run.frame.settings.clip == Clip::none && run.frame.is_drawn(*run.triangle);
}

void draw_coming(const Ui& ui, ImDrawList* list, const Pane& pane, const std::string& words) {
    const float u = ui.options.text_scale;
    const ImFont* const font = ui.fonts.small;
    list->AddText(font, font->FontSize,
                  {pane.low.x + 10.0f * u, pane.high.y - font->FontSize - coming_border * u},
                  packed(palette(ui.options.theme).dim), words.c_str());
}

} // namespace

void leave_outside(Ui& ui) {
    constexpr double half_a_minute = 30.0;
    if (!ui.canvas.outside_drawing || ImGui::GetTime() - ui.canvas.outside_shown < half_a_minute)
        return;
    ui.canvas.outside_drawing.reset();
    ui.canvas.outside.number = 0; // that of no drawing, so that the next one is shown
}

void draw_outside(Ui& ui, const Pane& pane) {
    if (!ui.canvas.outside_drawing) ui.canvas.outside_drawing = std::make_shared<OutsideDrawing>();
    ui.canvas.outside_shown = ImGui::GetTime();
    OutsideDrawing& drawing = *ui.canvas.outside_drawing;
    const float u = ui.options.text_scale;
    const Palette& p = palette(ui.options.theme);
    const ImVec2 room{std::max(pane.room().x, 1.0f), std::max(pane.room().y, 1.0f)};
    ImGui::SetCursorScreenPos(pane.low);
    // The caption's button lies on it.
    overlapped_button("outside", room,
                      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    register_widget(ui, "canvas.outside");
    const Arrows arrows = take_arrows(ui, "canvas.outside");
    if (arrows.right != 0 || arrows.up != 0) {
        turn_outside(ui, 0.1f * static_cast<float>(arrows.right),
                     0.1f * static_cast<float>(arrows.up));
    }
    const RunResults& a = ui.results.a;
    const OutsideSubject subject{a.drawn_scene(),   a.frame,           a.frame_number,
                                 a.cursor,          a.triangle,        a.picture,
                                 a.picture_number,  *a.framebuffer,    a.picture_before,
                                 a.picture_changed, world_clipping(ui)};
    // Picking uses what was last seen.
    if (drawing.number() > 0) handle_pointer(ui, pane);
    drawing.update(subject, look_of(ui, pane));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(pane.low, pane.high, packed(p.canvas), 4.0f * u);
    list->PushClipRect(pane.low, pane.high, true);
    draw_image(ui, list, pane);
    std::vector<Basis> bases = bases_of(a.frame, a.triangle);
    // The vectors have the same axes, at the picked pixel.
    if (a.inspected.vectors && a.inspected.vectors->pixel)
        std::erase_if(bases, [](const Basis& basis) { return basis.of == BasisOf::surface; });
    const OutsideMarks marks = outside_marks(
        *a.frame.scene, drawing.outside_scene(), drawing.eye(),
        {a.triangle, subject.clipping, is_mirrored_visible(a), divider_of(a.frame, a.triangle)},
        ui.session.selection.pixel, size_of(pane),
        {.bases = bases,
         .lamp_ray = lamp_ray_outside(a.frame, a.inspected.fragment),
         .shift = sight_shift_outside(a.inspected.fragment),
         .vectors =
             vectors_outside(a.inspected.vectors, drawing.eye(), double{direction_length(room, u)},
                             double{right_angle_side * u}),
         .textured = textured_pixel_outside(a.inspected.fragment)});
    const std::string coming = fitting_coming_words(ui, pane);
    const float below =
        coming.empty() ? 0.0f : ui.fonts.small->FontSize + (coming_border + coming_gap) * u;
    draw_outside_marks(ui, list, marks, pane, caption_height(ui), below);
    draw_caption(ui, list, pane);
    draw_coming(ui, list, pane, coming);
    list->PopClipRect();
    list->AddRect(pane.low, pane.high, packed(p.line), 4.0f * u);
}

bool is_outside_working(const Ui& ui) {
    return !ui.start.is_open && shown_on_canvas(ui) != CanvasShows::picture &&
           ui.canvas.outside_drawing && ui.canvas.outside_drawing->is_working();
}

std::string coming_words(int triangles, const Cursor& cursor) {
    if (triangles > most_ordered || is_square(cursor) || cursor.triangle >= triangles - 1)
        return {};
    const int first = cursor.triangle + 1;
    std::string words = "faint: still to come, triangles[" + std::to_string(first) + "]";
    if (first + 1 < triangles) words += " to triangles[" + std::to_string(triangles - 1) + "]";
    return words;
}

CanvasHalves canvas_halves(const Ui& ui, const Pane& canvas) {
    const float gap = std::round(8.0f * ui.options.text_scale);
    const ImVec2 room = canvas.room();
    CanvasHalves halves{canvas, canvas};
    if (room.x >= room.y) {
        const float width = std::floor(std::max(0.5f * (room.x - gap), 1.0f));
        halves.picture.high.x = canvas.low.x + width;
        halves.outside.low.x = std::min(canvas.low.x + width + gap, canvas.high.x - 1.0f);
    } else {
        const float height = std::floor(std::max(0.5f * (room.y - gap), 1.0f));
        halves.picture.high.y = canvas.low.y + height;
        halves.outside.low.y = std::min(canvas.low.y + height + gap, canvas.high.y - 1.0f);
    }
    return halves;
}

} // namespace rasterwalk
