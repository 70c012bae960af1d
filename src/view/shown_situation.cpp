#include "view/shown_situation.h"

#include <algorithm>

#include "base/error.h"
#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "pipeline/timeline.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// What `to` sets otherwise than `from`.
std::vector<std::string> assignments_between(const Settings& from, const Settings& to) {
    std::vector<std::string> list;
    for (const RunDifference& difference : run_differences(from, to))
        list.push_back(std::string(difference.setting).append("=").append(difference.b));
    return list;
}

std::optional<int> within(std::optional<int> number, int count) {
    return number && *number >= 0 && *number < count ? number : std::nullopt;
}

void tell_selection(const Session& session, Situation& s) {
    const Selection& selection = session.selection;
    const Viewport& size = session.settings.viewport;
    s.triangle = within(selection.triangle, static_cast<int>(session.scene->triangles.size()));
    s.vertex = within(selection.vertex, 3);
    s.row = within(selection.row, size.height);
    const std::optional<glm::ivec2>& pixel = selection.pixel;
    if (pixel && within(pixel->x, size.width) && within(pixel->y, size.height)) s.pixel = pixel;
}

void tell_canvas(const Session& session, Situation& s) {
    const CanvasView& canvas = session.canvas;
    if (!canvas.grid) s.grid = false;
    if (canvas.zoom <= 0.0f) return;
    s.zoom = std::clamp(canvas.zoom, smallest_zoom, largest_zoom);
    s.centre = {std::clamp(canvas.centre.x, -farthest_centre, farthest_centre),
                std::clamp(canvas.centre.y, -farthest_centre, farthest_centre)};
}

} // namespace

Situation situation_of(const Session& session, const Scene& original) {
    Situation s;
    s.vertices = moved_triangles(*session.scene, original);
    s.set = assignments_between(default_settings(original), session.settings);
    if (session.cursor != cursor_end) {
        const Frame frame = prepare_frame(*session.scene, session.settings);
        const Cursor cursor = Timeline(frame).at_or_after(session.cursor);
        if (cursor != cursor_end) s.cursor = cursor;
    }
    tell_selection(session, s);
    tell_canvas(session, s);
    if (session.tab != Session().tab) s.tab = session.tab;
    if (session.view != View::colour) s.view = session.view;
    if (!session.overlays.empty()) s.overlays = session.overlays;
    if (session.other) s.compare = assignments_between(session.settings, *session.other);
    if (session.compare_view != Session().compare_view) s.compare_view = session.compare_view;
    if (session.wipe != Session().wipe) s.wipe = std::clamp(session.wipe, 0.0f, 1.0f);
    if (session.depth_range && session.depth_range->far <= session.depth_range->near) {
        s.depth_range = session.depth_range;
    }
    return s;
}

Scene scene_in_file(const Session& session) {
    const Scene& scene = *session.scene;
    if (scene.path.empty()) {
        throw UsageError("the scene " + scene.name + " was not read from a file.");
    }
    return is_bench(scene) ? read_scene_file(scene.path) : scene;
}

} // namespace rasterwalk
