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
            .interpolation = settings.interpolation,
            .lighting = lighting_of(settings.stage),
            .light_rules = settings.light_rules,
            .behind_camera = settings.behind_camera,
            .outside_picture = settings.outside_picture,
            .rotation = settings.rotation,
            .image_axes = settings.image_axes};
}

LineRules line_rules(const Settings& settings) {
    return {.walk = settings.line_walk, .rounding = settings.rounding};
}

EdgeRules edge_rules(const Settings& settings, VaryingSet carried) {
    LineRules line = line_rules(settings);
    line.carried = carried;
    return {.line = line,
            .samples = settings.edge_samples,
            .row_start = settings.row_start,
            .window_width = settings.viewport.width};
}

PixelRules pixel_rules(const Settings& settings) {
    return {.light = settings.light,
            .light_rules = settings.light_rules,
            .interpolation = settings.interpolation,
            .lighting = lighting_of(settings.stage)};
}

PictureRules picture_rules(const Settings& settings) {
    return {.depth_clear = settings.depth_clear,
            .depth_index = settings.depth_index,
            .over_one = settings.colour_over_one};
}

Rectangle drawn_area(const Settings& settings) {
    const int first = settings.bounds == Bounds::excludes_zero ? 1 : 0;
    return {first, first, settings.viewport.width, settings.viewport.height};
}

DepthTest depth_rule(const Settings& settings) {
    return settings.stage >= Stage::depth ? settings.depth_test : DepthTest::off;
}

} // namespace rasterwalk
