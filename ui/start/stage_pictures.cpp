#include "ui/start/stage_pictures.h"

#include <algorithm>

#include "picture/thumbnail.h"
#include "pipeline/work.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

constexpr int largest_side = 400; ///< pixels

/// The scene with these settings at a step of the strip. A point is one pixel large: points are
/// drawn half as far apart, and shown at twice the size.
Image stage_picture(const Scene& scene, Settings settings, const StripStep& step, int side) {
    set_step(settings, step);
    return thumbnail(scene, settings, step.stage == Stage::points ? std::max(1, side / 2) : side);
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
    pictures.is_drawn = thumbnail_work(*scene, settings, side) * stage_count <= frame_limit.at_once;
    if (!pictures.is_drawn) return;
    for (std::size_t i = 0; i < pictures.textures.size(); ++i) {
        const Image image = stage_picture(*scene, settings, stage_list()[i].step, side);
        pictures.textures[i] = ui.host.textures->upload(pictures.textures[i], image);
    }
}

} // namespace rasterwalk
