#include "engines/refusal.h"

#include <fmt/format.h>

#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// The rules of stages that the other engines do without. Any but these would leave no trace.
constexpr RightValue rules_of_steps[] = {
    {"depth_test", "inverse_z"}, {"depth_format", "inv_z"},     {"depth_clear", "0"},
    {"depth_epsilon", "0"},      {"depth_index", "row_major"},  {"interpolation", "perspective"},
    {"rotation", "row_vector"},  {"camera_move", "subtracted"}, {"image_axes", "right_way"},
    {"divided_by", "z"},         {"outside_picture", "kept"},   {"translation", "last_column"},
    {"bounds", "inside"},        {"pixel_sample", "centre"},    {"weight_edge", "opposite"},
};

} // namespace

std::string other_than_right(const Settings& settings, std::span<const RightValue> right) {
    for (const RightValue& one : right) {
        const Setting* const setting = find_setting(one.setting);
        if (setting == nullptr || value_text(*setting, settings) != one.value)
            return fmt::format("{} other than {}", one.setting, one.value);
    }
    return {};
}

std::string only_steps_have(const Scene& scene, const Settings& settings) {
    if (hidden_rule(settings) != Hidden::depth_buffer)
        return "any removal of hidden surfaces except the depth buffer";
    if (draw_order_rule(settings) != DrawOrder::scene)
        return "any order of drawing except the scene's";
    if (sampling_rule(settings) != Sampling::centre) return "several samples of a pixel";
    if (settings.projection_mix != 0.0f) return "any projection except perspective";
    if (view_box_rule(settings, scene.space)) return "view_box other than auto";
    if (has_alpha(scene) && settings.blend != Blend::off)
        return "half-transparent surfaces (blend=off draws them opaque)";
    if (has_texture_alpha(scene) && settings.texture == TextureUse::on &&
        settings.texture_alpha != TextureAlpha::off)
        return "textures with alpha (texture_alpha=off draws them opaque)";
    if (settings.clip >= Clip::whole_only) return "mistakes in clipping";
    return other_than_right(settings, rules_of_steps);
}

} // namespace rasterwalk
