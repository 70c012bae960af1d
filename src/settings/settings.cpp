#include "settings/settings.h"

#include <algorithm>

#include "stages/orthographic.h"

namespace rasterwalk {

Settings default_settings(const Scene& scene) {
    Settings settings;
    settings.camera = scene.camera;
    settings.light = scene.light;
    settings.viewport = scene.viewport;
    if (const StageInfo* info = find_stage(scene.stage)) set_step(settings, info->step);
    return settings;
}

const StageInfo& stage_info(const Settings& settings) {
    const int place = strip_place({settings.stage, settings.shading});
    return stage_list()[static_cast<std::size_t>(place)];
}

StripStep step_of(const Settings& settings) {
    return stage_info(settings).step;
}

void set_step(Settings& settings, const StripStep& step) {
    settings.stage = step.stage;
    settings.shading = step.shading;
}

std::optional<Rounding> common_rounding(const Settings& settings) {
    const std::string_view word = word_of(settings.line_rounding);
    if (word_of(settings.vertex_rounding) != word) return std::nullopt;
    return settings.line_rounding;
}

void set_rounding(Settings& settings, Rounding rounding) {
    static_assert(enum_words<VertexRounding>[0] == enum_words<Rounding>[0] &&
                  enum_words<VertexRounding>[1] == enum_words<Rounding>[1] &&
                  enum_words<VertexRounding>[2] == enum_words<Rounding>[2]);
    settings.vertex_rounding = static_cast<VertexRounding>(rounding);
    settings.line_rounding = rounding;
}

Rounding sample_rounding(const Settings& settings) {
    return settings.line == LineAlgorithm::interpolate ? settings.line_rounding : Rounding::round;
}

float orthographic_depth_rule(const Settings& settings) {
    // What is closer than any near plane would enlarge beyond all numbers.
    constexpr float least = 1e-6f;
    return settings.orthographic_depth > 0.0f ? std::max(settings.orthographic_depth, least)
                                              : origin_depth(settings.camera, settings.near);
}

ClipDepth clip_depth_rule(const Settings& settings, SceneSpace space) {
    // What is given in pixels is projected already.
    const bool is_mixed = space == SceneSpace::world && settings.projection_mix > 0.0f;
    return is_mixed || settings.depth_format != DepthFormat::inv_z ? ClipDepth::reversed
                                                                   : ClipDepth::inv_z;
}

namespace {

Projection projection_rule(const Settings& settings, SceneSpace space) {
    Projection projection;
    projection.clip_depth = clip_depth_rule(settings, space);
    if (space == SceneSpace::pixels || settings.projection_mix == 0.0f) return projection;
    projection.mix = settings.projection_mix;
    projection.depth = orthographic_depth_rule(settings);
    return projection;
}

} // namespace

VertexRules vertex_rules(const Settings& settings, SceneSpace space) {
    return {.camera = settings.camera,
            .light = settings.light,
            .viewport = settings.viewport,
            .space = space,
            .rounding = settings.vertex_rounding,
            .shading = shading_rule(settings),
            .near = settings.near,
            .far = settings.far,
            .projection = projection_rule(settings, space)};
}

EdgeRules edge_rules(const Settings& settings, VaryingSet carried) {
    return {.rounding = sample_rounding(settings),
            .picture_width = settings.viewport.width,
            .carried = carried};
}

PixelRules pixel_rules(const Settings& settings) {
    return {.light = settings.light, .shading = shading_rule(settings)};
}

Coverage coverage_rule(const Settings& settings) {
    return settings.stage >= Stage::rows ? settings.coverage : Coverage::rows;
}

Shading shading_rule(const Settings& settings) {
    return settings.stage >= Stage::shade ? settings.shading : Shading::unlit;
}

DepthTest depth_rule(const Settings& settings) {
    return settings.stage >= Stage::depth ? settings.depth_test : DepthTest::off;
}

} // namespace rasterwalk
