#pragma once

#include "scene/scene.h"
#include "stages/stages.h"

namespace rasterwalk {

/// Every choice that changes the picture. The defaults are the lab's rules (preset `handout`);
/// camera, light and viewport come from the scene.
struct Settings {
    Stage stage = Stage::pixel_light;
    Rounding rounding = Rounding::truncate;
    LineWalk line_walk = LineWalk::accumulate;
    EdgeSamples edge_samples = EdgeSamples::longest_axis;
    DepthTest depth_test = DepthTest::inverse_z;
    Interpolation interpolation = Interpolation::perspective;
    Camera camera;
    Light light;
    Viewport viewport;

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// The lab's rules with the scene's own camera, light, viewport and stage.
Settings default_settings(const Scene& scene);

/// The part of the settings that each stage of the pipeline is told.
VertexRules vertex_rules(const Settings& settings, SceneSpace space);
LineRules line_rules(const Settings& settings);
EdgeRules edge_rules(const Settings& settings);
PixelRules pixel_rules(const Settings& settings);

/// The depth test in force: none before stage `depth`, whatever the setting says.
DepthTest depth_rule(const Settings& settings);

} // namespace rasterwalk
