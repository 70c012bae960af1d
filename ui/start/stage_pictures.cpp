#include "ui/start/stage_pictures.h"

#include <algorithm>
#include <cmath>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// What is drawn seven times within one frame of the window.
constexpr int most_triangles = 2000;
constexpr int largest_side = 400; ///< pixels

/// The scene with these settings at a step of the strip, `side` pixels high or wide, whichever is
/// more. A point is one pixel large: they are drawn half as far from each other, and shown twice as
/// large.
Image stage_picture(const Scene& scene, Settings settings, const StripStep& step, int side) {
    const int pixels = std::max(1, step.stage == Stage::points ? side / 2 : side);
    set_step(settings, step);
    const Viewport whole = settings.viewport;
    // Vertices that are given in pixels stay where they are.
    const float scale =
        scene.space == SceneSpace::pixels
            ? 1.0f
            : static_cast<float>(pixels) / static_cast<float>(std::max(whole.width, whole.height));
    const auto scaled = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
    };
    settings.viewport = {scaled(whole.width), scaled(whole.height)};
    settings.camera.focal_length *= scale;
    return view_image(draw_frame(prepare_frame(scene, settings)), View::colour);
}

} // namespace

void light_up(const Session& session, Settings& settings) {
    for (const Preset& preset : session.presets) {
        if (preset.name == "visible light") apply_preset(preset, settings);
    }
}

void renew_stage_pictures(Ui& ui, int side) {
    StagePictures& pictures = ui.start.pictures;
    const std::shared_ptr<const Scene>& scene = ui.session.scene;
    side = std::min(side, largest_side);
    if (pictures.scene == scene && pictures.side == side) return;
    pictures.scene = scene;
    pictures.side = side;
    pictures.is_drawn = scene->triangle_count() <= most_triangles;
    if (!pictures.is_drawn) return;
    Settings settings = default_settings(*scene);
    light_up(ui.session, settings);
    for (std::size_t i = 0; i < pictures.textures.size(); ++i) {
        const Image image = stage_picture(*scene, settings, stage_list()[i].step, side);
        pictures.textures[i] = ui.host.textures->upload(pictures.textures[i], image);
    }
}

} // namespace rasterwalk
