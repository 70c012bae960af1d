#include "ui/actions/zoom.h"

#include <algorithm>
#include <limits>

#include "ui/actions/picture_fit.h"
#include "ui/ui.h"
#include "view/view_state.h"

namespace rasterwalk {

namespace {

/// Around the triangle, pixels of the picture.
constexpr float room_around = 0.5f;

} // namespace

void zoom_to_triangle(Ui& ui) {
    const auto& widget = ui.widgets.find("canvas");
    if (!ui.results.a.triangle || widget == ui.widgets.end()) return;
    if (!ui.results.a.frame.is_drawn(*ui.results.a.triangle)) return;
    constexpr float infinite = std::numeric_limits<float>::infinity();
    PicturePart part{infinite, infinite, -infinite, -infinite};
    for (const ScreenVertex& vertex :
         ui.results.a.frame.triangle_vertices(*ui.results.a.triangle)) {
        const auto column = static_cast<float>(vertex.column), row = static_cast<float>(vertex.row);
        part = {std::min(part.left, column - room_around), std::min(part.top, row - room_around),
                std::max(part.right, column + 1.0f + room_around),
                std::max(part.bottom, row + 1.0f + room_around)};
    }
    const ImVec2 low = widget->second.top_left, high = widget->second.bottom_right;
    const PicturePlace place = fit_part(ui, part, low, high).place;
    // The middle of the triangle stays in its place, however the zoom is limited.
    const float zoom = std::clamp(place.scale, smallest_zoom, largest_zoom);
    const auto centre = [&](float middle, float origin, float from, float to) {
        const float at = origin + place.scale * middle;
        return middle + (0.5f * (from + to) - at) / zoom;
    };
    ui.session.canvas.zoom = zoom;
    ui.session.canvas.centre = {
        centre(0.5f * (part.left + part.right), place.origin.x, low.x, high.x),
        centre(0.5f * (part.top + part.bottom), place.origin.y, low.y, high.y)};
}

} // namespace rasterwalk
