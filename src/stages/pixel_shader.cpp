#include "stages/pixel_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

float weight_of(const Fragment& fragment, const Stages& stages) {
    return call<varying_weight>(stages.recovery_weight, fragment.inv_w);
}

Varyings recover_varyings(const Fragment& fragment, const Stages& stages) {
    return fragment.varyings / weight_of(fragment, stages);
}

TexturePlace place_in_texture(const Fragment& fragment, const Surface& surface,
                              const Stages& stages) {
    return texture_place(fragment.varyings.texcoord, weight_of(fragment, stages),
                         surface.texture_slope);
}

FragmentAlpha fragment_alpha(const Fragment& fragment, const Surface& surface,
                             const Stages& stages) {
    if (surface.texture_alpha == TextureAlpha::off) return {surface.alpha, false};
    const float alpha =
        sample_alpha(*surface.texture, place_in_texture(fragment, surface, stages), stages);
    if (surface.texture_alpha == TextureAlpha::blend) return {surface.alpha * alpha, false};
    const bool is_cut = alpha < cut_out_limit;
    return {is_cut ? alpha : surface.alpha, is_cut};
}

glm::vec3 painted(const glm::vec3& colour, const Fragment& fragment, const Surface& surface,
                  const Stages& stages) {
    return colour * stages.sample_texture(*surface.texture,
                                          place_in_texture(fragment, surface, stages), stages,
                                          nullptr);
}

glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages) {
    // Only the varyings that are read are divided: the pixel shader pays for no others.
    switch (rules.shading) {
    case Shading::unlit:
    case Shading::flat: // surface_shader() has it
        break;
    case Shading::gouraud:
        return textured(fragment.varyings.illumination / weight_of(fragment, stages), fragment,
                        surface, stages);
    case Shading::phong:
        return call<reflected_light>(
                   stages.reflected_light,
                   fragment.varyings.position_world / weight_of(fragment, stages), surface.normal,
                   textured(surface.reflectance, fragment, surface, stages), rules.light)
            .reflected;
    }
    return textured(surface.reflectance, fragment, surface, stages);
}

} // namespace rasterwalk
