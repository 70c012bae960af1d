#include "stages/pixel_shader.h"

namespace rasterwalk {

Varyings recover_varyings(const Fragment& fragment, Interpolation interpolation) {
    if (interpolation == Interpolation::affine) return fragment.varyings;
    return fragment.varyings / fragment.zinv;
}

namespace {

/// One varying as q: the pixel shader pays for no other.
template <class Value>
Value recover(const Fragment& fragment, Interpolation interpolation, Value Varyings::*member) {
    const Value& value = fragment.varyings.*member;
    return interpolation == Interpolation::affine ? value : value / fragment.zinv;
}

} // namespace

glm::vec3 pixel_shader(const Fragment& fragment, const Surface& surface, const PixelRules& rules) {
    switch (rules.lighting) {
    case Lighting::none:
        return surface.reflectance;
    case Lighting::per_vertex:
        return recover(fragment, rules.interpolation, &Varyings::illumination);
    case Lighting::per_pixel: {
        const glm::vec3 place = recover(fragment, rules.interpolation, &Varyings::position_world);
        // By the lab's own rules the compiler has nothing to decide at every pixel.
        if (rules.light_rules == LightRules{})
            return reflected_light(place, surface.normal, surface.reflectance, rules.light)
                .reflected;
        return reflected_light(place, surface.normal, surface.reflectance, rules.light,
                               rules.light_rules)
            .reflected;
    }
    }
    return surface.reflectance;
}

} // namespace rasterwalk
