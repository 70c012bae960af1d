#include "stages/pixel_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

float mixed_weight(float zinv, const Stages& stages) {
    const MixedWeight& weight = stages.mixed_weight;
    return (1.0f - weight.mix) + weight.mix * (weight.depth * zinv);
}

float weight_of(const Fragment& fragment, const Stages& stages) {
    return call<varying_weight>(stages.recovery_weight, fragment.inv_w, stages);
}

Varyings recover_varyings(const Fragment& fragment, const Stages& stages) {
    return fragment.varyings / weight_of(fragment, stages);
}

glm::vec3 surface_normal(const Fragment& fragment, const Surface& surface, const Camera& camera,
                         const Stages& stages) {
    if (!surface.differences.normals) return surface.normal;
    const glm::vec3 interpolated = fragment.varyings.normal / weight_of(fragment, stages);
    return stages.light_normal(stages.unit_normal(interpolated), camera);
}

TexturePlace carried_place(const Fragment& fragment, const Surface& surface, const Stages& stages) {
    return texture_place(fragment.varyings.texcoord, weight_of(fragment, stages),
                         surface.texture_slope);
}

ParallaxTerms parallax_terms(const Fragment& fragment, const Surface& surface,
                             const PixelRules& rules, const Stages& stages, SampledTexels* taken) {
    ParallaxTerms terms;
    const SurfaceHeights& heights = surface.heights;
    terms.stored =
        stages.sample_texture(*heights.map, carried_place(fragment, surface, stages), stages, taken)
            .r;
    terms.height = terms.stored * heights.scale + heights.bias;
    terms.axes = stages.tangent_frame(surface.uv_directions,
                                      surface_normal(fragment, surface, rules.camera, stages));
    const glm::vec3 ray =
        sight_ray(fragment.varyings.position_world / weight_of(fragment, stages), rules.rays);
    terms.to_eye = -ray / glm::length(ray);
    terms.view = along_axes(terms.to_eye, terms.axes);
    terms.step = stages.parallax_step(terms.height, terms.view);
    terms.shift = step_in_texture(terms.step, surface.uv_directions, terms.axes);
    return terms;
}

TexturePlace place_in_texture(const Fragment& fragment, const Surface& surface,
                              const PixelRules& rules, const Stages& stages) {
    TexturePlace place = carried_place(fragment, surface, stages);
    if (surface.heights.map != nullptr)
        place.texcoord += parallax_terms(fragment, surface, rules, stages, nullptr).shift;
    return place;
}

FragmentAlpha fragment_alpha(const Fragment& fragment, const Surface& surface,
                             const PixelRules& rules, const Stages& stages) {
    if (surface.texture_alpha == TextureAlpha::off) return {surface.alpha, false};
    const float alpha =
        sample_alpha(*surface.texture, place_in_texture(fragment, surface, rules, stages), stages);
    if (surface.texture_alpha == TextureAlpha::blend) return {surface.alpha * alpha, false};
    const bool is_cut = alpha < cut_out_limit;
    return {is_cut ? alpha : surface.alpha, is_cut};
}

glm::vec3 painted(const glm::vec3& colour, const Fragment& fragment, const Surface& surface,
                  const PixelRules& rules, const Stages& stages) {
    return colour * stages.sample_texture(*surface.texture,
                                          place_in_texture(fragment, surface, rules, stages),
                                          stages, nullptr);
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
                        surface, rules, stages);
    case Shading::phong:
        return call<reflected_light>(
                   stages.reflected_light,
                   fragment.varyings.position_world / weight_of(fragment, stages), surface.normal,
                   textured(surface.reflectance, fragment, surface, rules, stages), rules.light)
            .reflected;
    }
    return textured(surface.reflectance, fragment, surface, rules, stages);
}

} // namespace rasterwalk
