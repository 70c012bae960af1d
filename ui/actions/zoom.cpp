#include "ui/actions/zoom.h"

#include <algorithm>
#include <climits>
#include <cmath>

#include "ui/actions/row_table_layout.h"
#include "ui/ui.h"
#include "ui/widgets/layout.h"
#include "view/view_state.h"

namespace rasterwalk {

void zoom_to_triangle(Ui& ui) {
    const auto& widget = ui.widgets.find("canvas");
    if (!ui.results.a.triangle || widget == ui.widgets.end()) return;
    if (!ui.results.a.frame.is_drawn(*ui.results.a.triangle)) return;
    int left = INT_MAX, right = INT_MIN, top = INT_MAX, bottom = INT_MIN;
    for (const ScreenVertex& vertex :
         ui.results.a.frame.triangle_vertices(*ui.results.a.triangle)) {
        left = std::min(left, vertex.column);
        right = std::max(right, vertex.column);
        top = std::min(top, vertex.row);
        bottom = std::max(bottom, vertex.row);
    }
    const float u = ui.options.text_scale;
    const ImVec2 room{
        widget->second.bottom_right.x - widget->second.top_left.x - 2.0f * canvas_ruler * u,
        widget->second.bottom_right.y - widget->second.top_left.y - 2.0f * canvas_ruler * u};
    const float width = static_cast<float>(right - left + 1);
    const float height = static_cast<float>(bottom - top + 1);
    const auto zoom_in = [&](float room_x) {
        const float zoom = std::min(room_x / (width + 1.0f), room.y / (height + 1.0f));
        return std::clamp(zoom >= 4.0f ? std::floor(zoom) : zoom, smallest_zoom, largest_zoom);
    };
    ui.session.canvas.zoom = zoom_in(room.x);
    ui.session.canvas.centre = {static_cast<float>(left) + 0.5f * width,
                                static_cast<float>(top) + 0.5f * height};
    // Beside the row table, if the triangle is as large as its lines then.
    const float table = row_table_layout(ui, room.x).width;
    const float beside = zoom_in(std::max(room.x - table, 1.0f));
    if (table <= 0.0f || beside < row_table_zoom(ui)) return;
    ui.session.canvas.zoom = beside;
    ui.session.canvas.centre.x += 0.5f * table / beside;
}

} // namespace rasterwalk
