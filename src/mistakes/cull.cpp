#include "mistakes/cull.h"

#include <glm/geometric.hpp>

namespace rasterwalk {

Rejection cull_by_view_axis(std::span<const ClipVertex> corners, const VertexRules& rules,
                            const SightRays& rays, CullTest* test) {
    static_cast<void>(rules);
    const float along = glm::dot(corners.front().varyings.normal, rays.forward);
    const bool is_back = along > 0.0f;
    if (test != nullptr) {
        test->measure = "dot(n, forward)";
        test->reason = is_back ? "the normal points in the direction the camera looks"
                               : "the normal does not point in the direction the camera looks";
        test->is_back = is_back;
        test->values = {along};
    }
    return is_back ? Rejection::back_facing : Rejection::none;
}

Rejection cull_by_lamp(std::span<const ClipVertex> corners, const VertexRules& rules,
                       const SightRays& rays, CullTest* test) {
    static_cast<void>(rays);
    if (rules.space == SceneSpace::pixels) return Rejection::none;
    const Varyings face = as_one_face(corners);
    const float away = glm::dot(face.normal, face.position_world - rules.light.position);
    const bool is_back = away > 0.0f;
    if (test != nullptr) {
        test->measure = "dot(n, p - L)";
        test->reason = is_back ? "the normal points away from the lamp"
                               : "the normal does not point away from the lamp";
        test->is_back = is_back;
        test->values = {away};
    }
    return is_back ? Rejection::back_facing : Rejection::none;
}

} // namespace rasterwalk
