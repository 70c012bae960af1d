#include "ui/actions/zoom.h"

#include <algorithm>
#include <climits>
#include <cmath>

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
    const float zoom = std::min(room.x / (width + 1.0f), room.y / (height + 1.0f));
    ui.session.canvas.zoom =
        std::clamp(zoom >= 4.0f ? std::floor(zoom) : zoom, smallest_zoom, largest_zoom);
    ui.session.canvas.centre = {static_cast<float>(left) + 0.5f * width,
                                static_cast<float>(top) + 0.5f * height};
}

} // namespace rasterwalk
