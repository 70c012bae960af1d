#include "stages/vertex_shader.h"

#include <cmath>
#include <limits>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Varyings start_varyings(const Vertex& vertex, const VertexRules& rules, const Stages& stages) {
    Varyings varyings;
    varyings.position_world = vertex.position;
    varyings.normal = vertex.normal;
    varyings.colour = vertex.reflectance;
    if (rules.lighting == Lighting::per_vertex) {
        varyings.illumination =
            stages.reflected_light(vertex.position, vertex.normal, vertex.reflectance, rules.light)
                .reflected;
    }
    return varyings;
}

} // namespace

glm::mat3 camera_rotation(const Camera& camera) {
    const float cy = std::cos(camera.yaw), sy = std::sin(camera.yaw);
    const float cp = std::cos(camera.pitch), sp = std::sin(camera.pitch);
    // Columns are the camera's right, down and forward axes in the world.
    const glm::vec3 right(cy, 0.0f, -sy);
    const glm::vec3 down(sp * sy, cp, sp * cy);
    const glm::vec3 forward(cp * sy, -sp, cp * cy);
    return {right, down, forward};
}

glm::vec3 VertexSpaces::in(std::string_view space) const {
    for (const SpacePoint& point : points) {
        if (point.space == space) return point.place;
    }
    return glm::vec3(0.0f);
}

ClipVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                         const Stages& stages, VertexSpaces* spaces) {
    const bool is_projected = rules.space == SceneSpace::world;
    glm::vec3 minus_camera = vertex.position, rotated = vertex.position;
    float f = 1.0f;
    if (is_projected) {
        minus_camera = vertex.position - rules.camera.position;
        rotated = rules.rotation == Rotation::row_vector ? minus_camera * rotation
                                                         : rotation * minus_camera;
        f = rules.image_axes == ImageAxes::mirrored ? -rules.camera.focal_length
                                                    : rules.camera.focal_length;
    }
    if (spaces != nullptr) {
        spaces->add("world", vertex.position);
        spaces->add("minus_camera", minus_camera);
        spaces->add("rotated", rotated);
    }
    ClipVertex result;
    result.position_clip = is_finite(rotated)
                               ? glm::vec4(f * rotated.x, f * rotated.y, 1.0f, rotated.z)
                               : glm::vec4(std::numeric_limits<float>::quiet_NaN());
    result.varyings = start_varyings(vertex, rules, stages);
    return result;
}

} // namespace rasterwalk
