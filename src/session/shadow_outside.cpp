#include "session/shadow_outside.h"

namespace rasterwalk {

std::optional<SeenLampWay> lamp_way_outside(const Frame& frame,
                                            const std::optional<FragmentReport>& fragment) {
    if (!fragment || occluders_of(frame) == nullptr) return std::nullopt;
    const ShadowTerms& shadow = fragment->shading == Shading::flat
                                    ? fragment->light_per_triangle.shadow
                                    : fragment->light.shadow;
    if (!shadow.is_asked) return std::nullopt;
    SeenLampWay way{glm::dvec3(shadow.point.position_world), {}};
    if (shadow.hit.is_hit())
        way.met = glm::dvec3(shadow.ray.from) + double{shadow.hit.t} * glm::dvec3(shadow.ray.way);
    // On the way from the lamp, at the depth it saw.
    const glm::dvec3 lamp(shadow.point.lamp);
    for (int i = 0; i < shadow.texel_count && !way.met; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        if (!texel.is_lit)
            way.met = lamp + (way.from - lamp) / (double{texel.inv_depth} * double{shadow.seen.z});
    }
    return way;
}

} // namespace rasterwalk
