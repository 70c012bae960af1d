#include "ui/canvas/picture_view.h"

#include <algorithm>
#include <climits>
#include <cmath>

#include "ui/actions/picture_fit.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The table beside a zoomed picture: the roomiest that leaves room for the triangle on show; where
/// none does, the roomiest.
RowTableLayout table_beside_zoomed(const Ui& ui, float zoom, float canvas_width) {
    const std::vector<RowTableLayout> tables = row_table_layouts(ui, canvas_width);
    if (tables.empty()) return {};
    int first = INT_MAX, last = INT_MIN;
    for (const ScreenVertex& vertex :
         ui.results.a.frame.triangle_vertices(*ui.results.a.triangle)) {
        first = std::min(first, vertex.column);
        last = std::max(last, vertex.column);
    }
    const float needed = ruler_size(ui).x + zoom * static_cast<float>(last - first + 1);
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const RowTableLayout& table) {
        return table.width + needed <= canvas_width;
    });
    return found != tables.end() ? *found : tables.front();
}

PictureFit place_picture(const Ui& ui, const Pane& pane) {
    const CanvasView& canvas = ui.session.canvas;
    if (canvas.zoom <= 0.0f)
        return fit_part(ui, part_that_fits(ui, pane.low, pane.high), pane.low, pane.high);
    PictureFit placed;
    placed.place.scale = canvas.zoom;
    placed.place.origin = {
        std::round(0.5f * (pane.low.x + pane.high.x) - canvas.zoom * canvas.centre.x),
        std::round(0.5f * (pane.low.y + pane.high.y) - canvas.zoom * canvas.centre.y)};
    placed.table = table_beside_zoomed(ui, canvas.zoom, pane.room().x);
    return placed;
}

/// Sets zoom and centre such that the picture point under the pointer stays there.
void zoom_about(Ui& ui, ImVec2 pointer, float zoom, const Pane& pane) {
    const ImVec2 fixed_point = picture_point(ui.canvas.place, pointer);
    CanvasView& canvas = ui.session.canvas;
    canvas.zoom = std::clamp(zoom, smallest_zoom, largest_zoom);
    canvas.centre = {fixed_point.x - (pointer.x - 0.5f * (pane.low.x + pane.high.x)) / canvas.zoom,
                     fixed_point.y - (pointer.y - 0.5f * (pane.low.y + pane.high.y)) / canvas.zoom};
    ui.canvas.place = place_picture(ui, pane).place;
}

/// The next zoom step: factors of the square root of two, whole numbers from 4x on.
float next_zoom(float zoom, float wheel) {
    const float next = zoom * std::pow(2.0f, 0.5f * wheel);
    return next >= 4.0f ? std::round(next) : next;
}

} // namespace

RowTableLayout place_pictures(Ui& ui, const Panes& panes) {
    PictureFit placed = place_picture(ui, panes.a);
    // It does not move away under a vertex that is held.
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
    return placed.table;
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
