#include "stages/pixel_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

float weight_of(const Fragment& fragment, const Stages& stages) {
    return call<varying_weight>(stages.varying_weight, fragment.inv_w);
}

} // namespace

Varyings recover_varyings(const Fragment& fragment, const Stages& stages) {
    return fragment.varyings / weight_of(fragment, stages);
}

glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages) {
    // Only what is read is divided: the pixel shader pays for no other varying.
    switch (rules.shading) {
    case Shading::unlit:
    case Shading::flat: // surface_shader() knows it
        break;
    case Shading::gouraud:
        return fragment.varyings.illumination / weight_of(fragment, stages);
    case Shading::phong:
        return call<reflected_light>(stages.reflected_light,
                                     fragment.varyings.position_world / weight_of(fragment, stages),
                                     surface.normal, surface.reflectance, rules.light)
            .reflected;
    }
    return surface.reflectance;
}

} // namespace rasterwalk
