#include "ui/canvas/canvas_keys.h"

#include <algorithm>

#include "ui/canvas/canvas_pointer.h"
#include "ui/canvas/picture_view.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The middle of a pixel on the screen.
ImVec2 middle_of(const PicturePlace& place, glm::ivec2 pixel) {
    return {place.origin.x + place.scale * (static_cast<float>(pixel.x) + 0.5f),
            place.origin.y + place.scale * (static_cast<float>(pixel.y) + 0.5f)};
}

} // namespace

void handle_canvas_keys(Ui& ui, const Pane& pane, const Pane& seen) {
    const Arrows arrows = take_arrows(ui, "canvas");
    if (!ui.focus.is_shown || ui.focus.name != "canvas") return;
    const Viewport& size = ui.results.a.frame.settings.viewport;
    const bool is_arrow = arrows.right != 0 || arrows.up != 0;
    const int zoom_steps =
        (is_key_pressed(key::equal, true) ? 1 : 0) - (is_key_pressed(key::minus, true) ? 1 : 0);
    if (!is_arrow && (zoom_steps == 0 || ImGui::GetIO().KeyCtrl)) return;
    const std::optional<glm::ivec2> picked = ui.session.selection.pixel;
    glm::ivec2 pixel = picked.value_or(glm::ivec2(size.width / 2, size.height / 2));
    if (is_arrow) {
        if (picked) pixel += glm::ivec2(arrows.right, -arrows.up);
        pixel = {std::clamp(pixel.x, 0, size.width - 1), std::clamp(pixel.y, 0, size.height - 1)};
        pick_on_picture(ui, pixel, false);
    }
    if (zoom_steps != 0) {
        zoom_by_wheel(ui, middle_of(ui.canvas.place, pixel), static_cast<float>(zoom_steps), pane);
    }
    const ImVec2 at = middle_of(ui.canvas.place, pixel);
    const bool is_seen =
        at.x >= seen.low.x && at.y >= seen.low.y && at.x < seen.high.x && at.y < seen.high.y;
    if (is_seen) return;
    const ImVec2 middle{0.5f * (seen.low.x + seen.high.x), 0.5f * (seen.low.y + seen.high.y)};
    move_picture(ui, {middle.x - at.x, middle.y - at.y}, pane);
}

} // namespace rasterwalk
