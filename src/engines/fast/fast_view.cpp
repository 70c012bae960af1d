#include "engines/fast/fast_view.h"

#include <string>
#include <string_view>

#include "engines/refusal.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

void set(const glm::vec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = from[i];
}

/// The rules of light, textures and bytes that the engine has: any but these is a mistake, or
/// another right way.
constexpr RightValue rules_of_its_own[] = {
    {"normal_w", "zero"},
    {"texel_rule", "right"},
    {"light.direction", "to_light"},
    {"light.falloff", "sphere"},
    {"light.sum", "reflectance_times"},
    {"light.renormalize", "on"},
    {"light.highlight", "right"},
    {"encoding", "linear"},
    {"light.sides", "one"},
    {"colour_over_one", "clamp"},
    {"channel_order", "rgb"},
};

} // namespace

std::string fixed_rules_refuse(const std::string& engine, const Scene& scene,
                               const Settings& settings) {
    if (scene.space != SceneSpace::world)
        return engine + " draws scenes in the world, not in pixels";
    const auto unknown = [&engine](std::string_view what) {
        return engine + " does not support " + std::string(what);
    };
    if (settings.tessellation != 1) return unknown("tessellation");
    if (const std::string what = only_steps_have(scene, settings); !what.empty())
        return unknown(what);
    if (bends_normals(settings) && has_normal_map(scene))
        return unknown("normal maps (normal_map=off does without them)");
    if (shifts_textures(settings) && has_height_map(scene))
        return unknown("height maps (parallax=off does without them)");
    if (shadow_rule(settings, scene.space) != Shadows::off) return unknown("shadows");
    if (!scene.textures.empty() && settings.texture == TextureUse::on &&
        settings.texture_filter > TextureFilter::bilinear)
        return unknown("mipmaps (texture_filter=bilinear does without them)");
    if (settings.cull != Cull::none && settings.cull != Cull::screen_area)
        return unknown("any culling except cull=screen_area");
    if (const std::string other = other_than_right(settings, rules_of_its_own); !other.empty())
        return unknown(other);
    return {};
}

std::string fast_engine_refuses(const Scene& scene, const Settings& settings) {
    const std::string engine = "the fast engine";
    if (scene.space == SceneSpace::world) {
        if (settings.stage < Stage::depth) return engine + " does not support stages before depth";
        if (shading_rule(settings) == Shading::flat)
            return engine + " does not support shading=flat";
    }
    return fixed_rules_refuse(engine, scene, settings);
}

fast::View fast_view(const FastEye& eye) {
    fast::View view{};
    view.width = eye.size.width;
    view.height = eye.size.height;
    set(eye.position, view.eye);
    for (int i = 0; i < 3; ++i)
        set(eye.rotation[i], view.axes[i]);
    view.focal_length = eye.focal_length;
    view.middle[0] = eye.middle.x;
    view.middle[1] = eye.middle.y;
    view.near = eye.near;
    view.light_at = fast::LightAt::nowhere;
    return view;
}

fast::View fast_view(const Settings& settings) {
    const Viewport& size = settings.viewport;
    const Light light = light_rule(settings);
    fast::View view = fast_view({.size = size,
                                 .position = settings.camera.position,
                                 .rotation = camera_rotation(settings.camera),
                                 .focal_length = settings.camera.focal_length,
                                 .middle = {size.width / 2, size.height / 2},
                                 .near = settings.near});
    set(light.position, view.lamp);
    set(light.power, view.power);
    set(light.indirect, view.indirect);
    view.exponent = light.exponent;
    view.has_highlights = light.model == LightModel::blinn_phong ? 1 : 0;
    view.shows_textures = settings.texture == TextureUse::on ? 1 : 0;
    view.culls_backs = settings.cull != Cull::none ? 1 : 0;
    switch (shading_rule(settings)) {
    case Shading::unlit:
        view.light_at = fast::LightAt::nowhere;
        break;
    case Shading::gouraud:
        view.light_at = fast::LightAt::vertices;
        break;
    case Shading::flat:
    case Shading::phong:
        view.light_at = fast::LightAt::pixels;
        break;
    }
    view.wrap = settings.texture_wrap == TextureWrap::clamp    ? fast::Wrap::clamp
                : settings.texture_wrap == TextureWrap::mirror ? fast::Wrap::mirror
                                                               : fast::Wrap::repeat;
    view.is_bilinear = settings.texture_filter != TextureFilter::nearest ? 1 : 0;
    return view;
}

} // namespace rasterwalk
