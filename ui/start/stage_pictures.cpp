#include "ui/start/stage_pictures.h"

#include <algorithm>
#include <cmath>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/work.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

constexpr int largest_side = 400; ///< pixels

/// The settings for a picture of so many pixels, the higher or the wider.
Settings scaled_to(const Scene& scene, Settings settings, int pixels) {
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
    return settings;
}

/// What it costs to draw the scene once, with everything.
double work_of(const Scene& scene, const Settings& settings, int side) {
    const Frame frame = prepare_frame(scene, scaled_to(scene, settings, side));
    FrameWork work;
    work.begin(frame);
    return work.total();
}

/// The scene with these settings at a step of the strip. A point is one pixel large: they are drawn
/// half as far from each other, and shown twice as large.
Image stage_picture(const Scene& scene, Settings settings, const StripStep& step, int side) {
    set_step(settings, step);
    settings =
        scaled_to(scene, settings, step.stage == Stage::points ? std::max(1, side / 2) : side);
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
    Settings settings = default_settings(*scene);
    light_up(ui.session, settings);
    pictures.is_drawn = work_of(*scene, settings, side) * stage_count <= frame_limit.at_once;
    if (!pictures.is_drawn) return;
    for (std::size_t i = 0; i < pictures.textures.size(); ++i) {
        const Image image = stage_picture(*scene, settings, stage_list()[i].step, side);
        pictures.textures[i] = ui.host.textures->upload(pictures.textures[i], image);
    }
}

} // namespace rasterwalk
