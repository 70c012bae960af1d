#include "settings/settings.h"

#include <algorithm>
#include <array>

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
    // A depth smaller than any near plane would enlarge things beyond all numbers.
    constexpr float least = 1e-6f;
    return settings.orthographic_depth > 0.0f ? std::max(settings.orthographic_depth, least)
                                              : origin_depth(settings.camera, settings.near);
}

namespace {

/// The meaning of a word of the depth format.
struct DepthFormatInfo {
    DepthFormat format;
    ClipDepth holds;
    int bits; ///< 0: a float
};

const DepthFormatInfo& depth_format_info(DepthFormat format) {
    static constexpr std::array list{
        DepthFormatInfo{DepthFormat::inv_z, ClipDepth::inv_z, 0},
        DepthFormatInfo{DepthFormat::inv_z_24, ClipDepth::inv_z, 24},
        DepthFormatInfo{DepthFormat::inv_z_16, ClipDepth::inv_z, 16},
        DepthFormatInfo{DepthFormat::ndc_32, ClipDepth::ndc, 0},
        DepthFormatInfo{DepthFormat::ndc_24, ClipDepth::ndc, 24},
        DepthFormatInfo{DepthFormat::ndc_16, ClipDepth::ndc, 16},
        DepthFormatInfo{DepthFormat::reversed_32, ClipDepth::reversed, 0},
        DepthFormatInfo{DepthFormat::reversed_24, ClipDepth::reversed, 24},
        DepthFormatInfo{DepthFormat::reversed_16, ClipDepth::reversed, 16},
    };
    static_assert(is_indexed_by(list, &DepthFormatInfo::format));
    return list[static_cast<std::size_t>(format)];
}

} // namespace

std::optional<ViewBox> view_box_rule(const Settings& settings, SceneSpace space) {
    const bool is_known = space == SceneSpace::world && settings.transform == Transform::matrices;
    return is_known ? settings.view_box : std::nullopt;
}

ClipDepth clip_depth_rule(const Settings& settings, SceneSpace space) {
    const ClipDepth chosen = depth_format_info(settings.depth_format).holds;
    // A scene in pixels is already projected.
    const bool is_mixed = space == SceneSpace::world && settings.projection_mix > 0.0f;
    return is_mixed && chosen == ClipDepth::inv_z ? ClipDepth::reversed : chosen;
}

CameraMove camera_move_rule(const Settings& settings) {
    return settings.transform == Transform::lab ? settings.camera_move : CameraMove::subtracted;
}

DividedBy divided_by_rule(const Settings& settings) {
    const bool is_labs = settings.transform == Transform::lab && settings.projection_mix == 0.0f;
    return is_labs ? settings.divided_by : DividedBy::z;
}

namespace {

Projection projection_rule(const Settings& settings, SceneSpace space) {
    Projection projection;
    projection.clip_depth = clip_depth_rule(settings, space);
    if (space == SceneSpace::pixels) return projection;
    projection.box = view_box_rule(settings, space);
    if (settings.projection_mix != 0.0f) {
        projection.mix = settings.projection_mix;
        projection.depth = orthographic_depth_rule(settings);
    }
    if (projection.box) projection.depth = settings.near;
    return projection;
}

} // namespace

MixedWeight mixed_weight_rule(const Settings& settings, SceneSpace space) {
    return {settings.interpolation_mix,
            space == SceneSpace::world ? orthographic_depth_rule(settings) : 1.0f};
}

float alpha_rule(const Settings& settings, const Scene& scene, int triangle) {
    const float own = alpha_of(scene, triangle);
    return own < 1.0f && settings.surface_alpha > 0.0f ? settings.surface_alpha : own;
}

DepthRules depth_rules(const Settings& settings, SceneSpace space) {
    return {.projection = projection_rule(settings, space),
            .near = settings.near,
            .far = settings.far,
            .bits = depth_format_info(settings.depth_format).bits,
            .epsilon = depth_epsilon_rule(settings)};
}

float depth_clear_rule(const Settings& settings, SceneSpace space) {
    const ClipDepth kind = clip_depth_rule(settings, space);
    const float clear =
        is_smaller_nearer(kind) ? 1.0f - settings.depth_clear : settings.depth_clear;
    return depth_in_buffer(clear, depth_rules(settings, space));
}

float depth_epsilon_rule(const Settings& settings) {
    return depth_rule(settings) == DepthTest::inverse_z ? settings.depth_epsilon : 0.0f;
}

Light light_rule(const Settings& settings) {
    Light light = settings.light;
    if (light.place == LampPlace::camera) light.position = settings.camera.position;
    return light;
}

VertexRules vertex_rules(const Settings& settings, SceneSpace space) {
    return {.camera = settings.camera,
            .light = light_rule(settings),
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

PixelRules pixel_rules(const Settings& settings, SceneSpace space) {
    return {.light = light_rule(settings),
            .shading = shading_rule(settings),
            .camera = settings.camera,
            .rays = sight_rays(vertex_rules(settings, space))};
}

Coverage coverage_rule(const Settings& settings) {
    return settings.stage >= Stage::rows ? settings.coverage : Coverage::rows;
}

Sampling sampling_rule(const Settings& settings) {
    const bool has_places = coverage_rule(settings) != Coverage::rows &&
                            has_fragments(settings.stage) &&
                            hidden_rule(settings) != Hidden::warnock;
    if (!has_places) return Sampling::centre;
    if (settings.supersample > 1) return Sampling::supersample;
    return settings.samples > 1 ? Sampling::multisample : Sampling::centre;
}

WeightEdge weight_edge_rule(const Settings& settings) {
    const bool has_edge_functions = coverage_rule(settings) == Coverage::edge_functions;
    return has_edge_functions ? settings.weight_edge : WeightEdge::opposite;
}

Shading shading_rule(const Settings& settings) {
    return settings.stage >= Stage::shade ? settings.shading : Shading::unlit;
}

Shadows shadow_rule(const Settings& settings, SceneSpace space) {
    const bool has_light = shading_rule(settings) != Shading::unlit && space == SceneSpace::world;
    return has_light ? settings.shadows : Shadows::off;
}

bool bends_normals(const Settings& settings) {
    return settings.normal_map == NormalMapUse::on && shading_rule(settings) == Shading::phong;
}

bool shifts_textures(const Settings& settings) {
    return settings.parallax != Parallax::off && shading_rule(settings) == Shading::phong;
}

Hidden hidden_rule(const Settings& settings) {
    return settings.stage >= Stage::depth ? settings.hidden : Hidden::depth_buffer;
}

DrawOrder draw_order_rule(const Settings& settings) {
    const bool has_buffer = hidden_rule(settings) == Hidden::depth_buffer;
    return settings.stage >= Stage::depth && has_buffer ? settings.draw_order : DrawOrder::scene;
}

bool follows_scene_order(const Settings& settings) {
    return hidden_rule(settings) == Hidden::depth_buffer &&
           draw_order_rule(settings) == DrawOrder::scene;
}

DepthTest depth_rule(const Settings& settings) {
    const bool has_buffer = hidden_rule(settings) == Hidden::depth_buffer;
    return settings.stage >= Stage::depth && has_buffer ? settings.depth_test : DepthTest::off;
}

} // namespace rasterwalk
