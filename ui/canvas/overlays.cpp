#include "ui/canvas/overlays.h"

#include <algorithm>

#include "picture/overlay.h"
#include "ui/canvas/field_marks.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/picture_texture.h"

namespace rasterwalk {

namespace {

/// Lines that may be seen between `low` and `high`.
bool may_cross(ImVec2 a, ImVec2 b, ImVec2 low, ImVec2 high) {
    return std::max(a.x, b.x) >= low.x && std::min(a.x, b.x) <= high.x &&
           std::max(a.y, b.y) >= low.y && std::min(a.y, b.y) <= high.y;
}

void draw_wires(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high) {
    const PicturePlace& place = ui.canvas.place;
    const float u = ui.options.text_scale;
    // A dark line under the bright one keeps it visible on every ground; a carpet has no ground.
    const bool is_carpet = ui.results.overlay.wires.size() > most_wires / 4;
    for (const bool is_shadow : {true, false}) {
        if (is_shadow && is_carpet) continue;
        const ImU32 colour = is_shadow ? IM_COL32(0, 0, 0, 120) : IM_COL32(255, 255, 255, 225);
        for (const WireEdge& wire : ui.results.overlay.wires) {
            const ImVec2 a = place.middle_of(wire.from), b = place.middle_of(wire.to);
            if (may_cross(a, b, low, high))
                list->AddLine(a, b, colour, (is_shadow ? 3.0f : 1.0f) * u);
        }
    }
}

} // namespace

void show_ground(Ui& ui, ImVec2 low, ImVec2 high) {
    const Results& results = ui.results;
    const bool has_ground = !results.ground.rgba.empty() && !results.a.preview.is_shown;
    const NumberedPicture picture = has_ground
                                        ? NumberedPicture{results.ground, results.ground_number}
                                        : shown_picture(results.a);
    show_texture(ui, ui.canvas.picture, picture, ui.canvas.place, low, high);
}

void draw_overlays(Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high) {
    if (ui.results.a.preview.is_shown) return; // they lie over the steps' picture
    const OverlayPicture& picture = ui.results.overlay;
    if (!picture.image.rgba.empty()) {
        show_texture(ui, ui.canvas.overlay, {picture.image, ui.results.overlay_number},
                     ui.canvas.place, low, high);
        draw_texture(list, ui.canvas.overlay, ui.canvas.place);
    }
    draw_wires(ui, list, low, high);
    draw_field_lines(ui, list, low, high);
    draw_weight_parts(ui, list);
}

} // namespace rasterwalk
