#pragma once

#include "scene/scene.h"
#include "settings/choices.h"
#include "stages/pixel_shader.h"
#include "stages/polygon_rows.h"
#include "stages/stages.h"

namespace rasterwalk {

/// Every choice that changes the picture, or the work that it takes. The defaults are the lab's
/// rules (preset `handout`); camera, light and viewport come from the scene.
struct Settings {
    Stage stage = Stage::pixel_light;
    Rounding rounding = Rounding::truncate;
    LineWalk line_walk = LineWalk::accumulate;
    EdgeSamples edge_samples = EdgeSamples::longest_axis;
    RowStart row_start = RowStart::extreme;
    RowSearch row_search = RowSearch::indexed;
    EmptyRows empty_rows = EmptyRows::skipped;
    Spans spans = Spans::inclusive;
    Bounds bounds = Bounds::inside;
    DepthTest depth_test = DepthTest::inverse_z;
    float depth_clear = 0.0f; ///< 1/z that the depth buffer starts with
    DepthIndex depth_index = DepthIndex::row_major;
    Interpolation interpolation = Interpolation::perspective;
    Shading shading = Shading::after_depth_test;
    Camera camera;
    Rotation rotation = Rotation::row_vector;
    ImageAxes image_axes = ImageAxes::right_way;
    BehindCamera behind_camera = BehindCamera::left_out;
    OutsidePicture outside_picture = OutsidePicture::kept;
    Light light;
    LightRules light_rules;
    ColourOverOne colour_over_one = ColourOverOne::clamp;
    Viewport viewport;

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// The lab's rules with the scene's own camera, light, viewport and stage.
Settings default_settings(const Scene& scene);

/// The part of the settings that each stage of the pipeline is told.
VertexRules vertex_rules(const Settings& settings, SceneSpace space);
/// @param carried the varyings that are wanted; where only places count, none
EdgeRules edge_rules(const Settings& settings, VaryingSet carried = VaryingSet::all());
PixelRules pixel_rules(const Settings& settings);

/// The depth test in force: none before stage `depth`, whatever the setting says.
DepthTest depth_rule(const Settings& settings);

} // namespace rasterwalk
