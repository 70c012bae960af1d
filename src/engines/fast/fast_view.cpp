#include "engines/fast/fast_view.h"

#include <string>
#include <string_view>
#include <utility>

#include "settings/setting_table.h"
#include "stages/vertex_shader.h"

namespace rasterwalk {

namespace {

/// Is this word of a setting chosen? The engine does not have what it asks for.
bool is_chosen(std::string_view name, std::string_view word, const Settings& settings) {
    const Setting* setting = find_setting(name);
    return setting != nullptr && value_text(*setting, settings) == word;
}

void set(const glm::vec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = from[i];
}

} // namespace

std::string fast_engine_refuses(const Scene& scene, const Settings& settings) {
    if (scene.space != SceneSpace::world)
        return "the fast engine draws scenes in the world, not in pixels";
    const auto unknown = [](std::string_view what) {
        return "the fast engine does not support " + std::string(what);
    };
    if (settings.stage < Stage::depth) return unknown("stages before depth");
    if (settings.tessellation != 1) return unknown("tessellation");
    if (hidden_rule(settings) != Hidden::depth_buffer)
        return unknown("any removal of hidden surfaces except the depth buffer");
    if (sampling_rule(settings) != Sampling::centre) return unknown("several samples of a pixel");
    if (settings.projection_mix != 0.0f) return unknown("any projection except perspective");
    if (view_box_rule(settings, scene.space)) return unknown("view_box other than auto");
    if (shading_rule(settings) == Shading::flat) return unknown("shading=flat");
    if (has_alpha(scene) && settings.blend != Blend::off)
        return unknown("half-transparent surfaces (blend=off draws them opaque)");
    if (has_texture_alpha(scene) && settings.texture == TextureUse::on &&
        settings.texture_alpha != TextureAlpha::off)
        return unknown("textures with alpha (texture_alpha=off draws them opaque)");
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
    if (settings.clip >= Clip::whole_only) return unknown("mistakes in clipping");
    // The right values by the lab's rules: any other is a mistake, or another right way.
    for (const auto& [name, right] :
         {std::pair<std::string_view, std::string_view>{"depth_test", "inverse_z"},
          {"depth_format", "inv_z"},
          {"depth_clear", "0"},
          {"depth_epsilon", "0"},
          {"depth_index", "row_major"},
          {"interpolation", "perspective"},
          {"rotation", "row_vector"},
          {"camera_move", "subtracted"},
          {"image_axes", "right_way"},
          {"divided_by", "z"},
          {"outside_picture", "kept"},
          {"translation", "last_column"},
          {"normal_w", "zero"},
          {"bounds", "inside"},
          {"pixel_sample", "centre"},
          {"weight_edge", "opposite"},
          {"texel_rule", "right"},
          {"light.direction", "to_light"},
          {"light.falloff", "sphere"},
          {"light.sum", "reflectance_times"},
          {"light.renormalize", "on"},
          {"light.highlight", "right"},
          {"encoding", "linear"},
          {"light.sides", "one"},
          {"colour_over_one", "clamp"},
          {"channel_order", "rgb"}}) {
        if (!is_chosen(name, right, settings))
            return unknown(std::string(name) + " other than " + std::string(right));
    }
    return {};
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
