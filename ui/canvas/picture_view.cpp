#include "ui/canvas/picture_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/actions/picture_fit.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Where the picture lies, and the tables that may be next to it.
struct Placed {
    PicturePlace place;
    std::vector<RowTableLayout> tables;
};

Placed place_picture(Ui& ui, const Pane& pane) {
    const CanvasView& canvas = ui.session.canvas;
    if (canvas.zoom <= 0.0f) {
        const PicturePart part = part_that_fits(ui, pane.low, pane.high);
        const PictureFit fit = fit_part(ui, part, pane.low, pane.high);
        Placed placed{fit.place, {}};
        if (fit.table.width > 0.0f) placed.tables.push_back(fit.table);
        return placed;
    }
    PicturePlace place;
    place.scale = canvas.zoom;
    place.origin = {std::round(0.5f * (pane.low.x + pane.high.x) - canvas.zoom * canvas.centre.x),
                    std::round(0.5f * (pane.low.y + pane.high.y) - canvas.zoom * canvas.centre.y)};
    return {place, row_table_layouts(ui, pane.room().x)};
}

/// Sets zoom and centre so that the picture point under the pointer stays there.
void zoom_about(Ui& ui, ImVec2 pointer, float zoom, const Pane& pane) {
    const ImVec2 fixed_point = picture_point(ui.canvas.place, pointer);
    CanvasView& canvas = ui.session.canvas;
    canvas.zoom = std::clamp(zoom, smallest_zoom, largest_zoom);
    canvas.centre = {fixed_point.x - (pointer.x - 0.5f * (pane.low.x + pane.high.x)) / canvas.zoom,
                     fixed_point.y - (pointer.y - 0.5f * (pane.low.y + pane.high.y)) / canvas.zoom};
    ui.canvas.place = place_picture(ui, pane).place;
}

/// The next zoom step: factors of the square root of two, whole numbers from 4x up.
float next_zoom(float zoom, float wheel) {
    const float next = zoom * std::pow(2.0f, 0.5f * wheel);
    return next >= 4.0f ? std::round(next) : next;
}

} // namespace

std::vector<RowTableLayout> place_pictures(Ui& ui, const Panes& panes) {
    Placed placed = place_picture(ui, panes.a);
    // It stays in place under a vertex that is held.
    const bool is_held = ui.session.canvas.zoom <= 0.0f && ui.canvas.dragged_vertex >= 0;
    if (is_held) placed.place = ui.canvas.place;
    ui.canvas.place = placed.place;
    ui.compare.place_of_b = std::nullopt;
    const ImVec2 aside{panes.b.low.x - panes.a.low.x, panes.b.low.y - panes.a.low.y};
    if (aside.x > 0.0f || aside.y > 0.0f) {
        ui.compare.place_of_b = ui.canvas.place;
        ui.compare.place_of_b->origin.x += aside.x;
        ui.compare.place_of_b->origin.y += aside.y;
    }
    return std::move(placed.tables);
}

NumberedPicture shown_picture(const RunResults& run) {
    if (run.preview.is_shown) return {run.preview.picture, run.preview.number};
    return {run.picture, run.picture_number, run.picture_before, run.picture_changed};
}

std::optional<glm::ivec2> pixel_in_focus(const Ui& ui) {
    const auto pixel =
        ui.canvas.hovered_pixel ? ui.canvas.hovered_pixel : ui.session.selection.pixel;
    const bool is_inside = pixel && ui.results.a.framebuffer->contains(pixel->x, pixel->y);
    return is_inside ? pixel : std::nullopt;
}

ImVec2 picture_point(const PicturePlace& place, ImVec2 screen) {
    return {(screen.x - place.origin.x) / place.scale, (screen.y - place.origin.y) / place.scale};
}

void zoom_by_wheel(Ui& ui, ImVec2 pointer, float wheel, const Pane& pane) {
    zoom_about(ui, pointer, next_zoom(ui.canvas.place.scale, wheel), pane);
}

void move_picture(Ui& ui, ImVec2 by, const Pane& pane) {
    CanvasView& canvas = ui.session.canvas;
    if (canvas.zoom <= 0.0f) {
        const ImVec2 middle{0.5f * (pane.low.x + pane.high.x), 0.5f * (pane.low.y + pane.high.y)};
        zoom_about(ui, middle, ui.canvas.place.scale, pane);
    }
    canvas.centre.x -= by.x / canvas.zoom;
    canvas.centre.y -= by.y / canvas.zoom;
    ui.canvas.place = place_picture(ui, pane).place;
}

} // namespace rasterwalk
