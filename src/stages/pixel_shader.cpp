#include "stages/pixel_shader.h"

#include "stages/stage_table.h"

namespace rasterwalk {

Varyings recover_varyings(const Fragment& fragment, const Stages& stages) {
    return fragment.varyings / stages.varying_weight(fragment.inv_w);
}

glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules,
                       const Stages& stages) {
    // Only what is read is divided: the pixel shader pays for no other varying.
    switch (rules.lighting) {
    case Lighting::none:
        break;
    case Lighting::per_vertex:
        return fragment.varyings.illumination / stages.varying_weight(fragment.inv_w);
    case Lighting::per_pixel:
        return stages
            .reflected_light(fragment.varyings.position_world /
                                 stages.varying_weight(fragment.inv_w),
                             surface.normal, surface.reflectance, rules.light)
            .reflected;
    }
    return surface.reflectance;
}

} // namespace rasterwalk
