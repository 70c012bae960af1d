#include "ui/actions/outside.h"

#include "ui/ui.h"

namespace rasterwalk {

CanvasShows shown_on_canvas(const Ui& ui) {
    return shown_on_canvas(ui.session.canvas, *ui.session.scene);
}

void show_on_canvas(Ui& ui, CanvasShows shows) {
    if (shows != CanvasShows::picture && ui.session.scene->space != SceneSpace::world) {
        ui.session.notice = "This scene is given in pixels, so it has no camera to be seen from "
                            "outside.";
        return;
    }
    ui.session.canvas.shows = shows;
}

void switch_canvas(Ui& ui, CanvasShows shows) {
    show_on_canvas(ui, shown_on_canvas(ui) == shows ? CanvasShows::picture : shows);
}

void switch_camera_view(Ui& ui) {
    OutsideView& view = ui.session.canvas.outside;
    view.is_camera = !view.is_camera;
    if (shown_on_canvas(ui) == CanvasShows::picture) show_on_canvas(ui, CanvasShows::outside);
}

void turn_outside(Ui& ui, float yaw, float pitch) {
    OutsideView& view = ui.session.canvas.outside;
    if (view.is_camera) {
        const Camera& camera = ui.session.a.settings.camera;
        view = OutsideView();
        view.yaw = camera.yaw;
        view.pitch = camera.pitch;
    }
    view = turned(view, yaw, pitch);
}

} // namespace rasterwalk
