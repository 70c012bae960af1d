#include "settings/settings.h"

namespace rasterwalk {

Settings default_settings(const Scene& scene) {
    Settings settings;
    settings.camera = scene.camera;
    settings.light = scene.light;
    settings.viewport = scene.viewport;
    for (const StageInfo& info : stage_list()) {
        if (info.name == scene.stage) settings.stage = info.stage;
    }
    return settings;
}

VertexRules vertex_rules(const Settings& settings, SceneSpace space) {
    return {.camera = settings.camera,
            .light = settings.light,
            .viewport = settings.viewport,
            .space = space,
            .rounding = settings.rounding,
            .lighting = lighting_of(settings.stage)};
}

EdgeRules edge_rules(const Settings& settings, VaryingSet carried) {
    return {.rounding = settings.rounding,
            .picture_width = settings.viewport.width,
            .carried = carried};
}

PixelRules pixel_rules(const Settings& settings) {
    return {.light = settings.light, .lighting = lighting_of(settings.stage)};
}

DepthTest depth_rule(const Settings& settings) {
    return settings.stage >= Stage::depth ? settings.depth_test : DepthTest::off;
}

} // namespace rasterwalk
