#include "stages/vertex_shader.h"

#include <algorithm>
#include <cmath>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Varyings start_varyings(const Vertex& vertex, float zinv, const VertexRules& rules,
                        const Stages& stages) {
    Varyings varyings;
    varyings.position_world = vertex.position;
    varyings.normal = vertex.normal;
    varyings.colour = vertex.reflectance;
    if (rules.lighting == Lighting::per_vertex) {
        varyings.illumination =
            stages.reflected_light(vertex.position, vertex.normal, vertex.reflectance, rules.light)
                .reflected;
    }
    return varyings * stages.varying_weight(zinv);
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

ShadedVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation,
                           const VertexRules& rules, const Stages& stages) {
    ShadedVertex shaded;
    shaded.position_world = vertex.position;
    int middle_column = 0, middle_row = 0;
    if (rules.space == SceneSpace::pixels) {
        shaded.minus_camera = shaded.position_camera = vertex.position;
        shaded.projected_x = vertex.position.x;
        shaded.projected_y = vertex.position.y;
    } else {
        shaded.minus_camera = vertex.position - rules.camera.position;
        shaded.position_camera = rules.rotation == Rotation::row_vector
                                     ? shaded.minus_camera * rotation
                                     : rotation * shaded.minus_camera;
        middle_column = rules.viewport.width / 2;
        middle_row = rules.viewport.height / 2;
    }
    const float z = shaded.position_camera.z;
    if (!is_finite(shaded.position_camera)) {
        shaded.fault = VertexFault::not_finite;
        return shaded;
    }
    if (!(z > 0.0f) && rules.behind_camera != BehindCamera::drawn) {
        shaded.fault = VertexFault::behind_camera;
        return shaded;
    }
    const float zinv = 1.0f / z;
    if (rules.space == SceneSpace::world) {
        const float f = rules.image_axes == ImageAxes::mirrored ? -rules.camera.focal_length
                                                                : rules.camera.focal_length;
        shaded.projected_x = f * shaded.position_camera.x * zinv;
        shaded.projected_y = f * shaded.position_camera.y * zinv;
    }
    // Written so that NaN, which no comparison admits, is caught as well.
    if (!(std::abs(shaded.projected_x) <= max_pixel_distance &&
          std::abs(shaded.projected_y) <= max_pixel_distance && std::isfinite(zinv))) {
        shaded.fault = VertexFault::too_far_out;
        return shaded;
    }
    shaded.pixel.column = to_pixel(shaded.projected_x, rules.rounding) + middle_column;
    shaded.pixel.row = to_pixel(shaded.projected_y, rules.rounding) + middle_row;
    if (rules.outside_picture == OutsidePicture::clamped) {
        shaded.pixel.column = std::clamp(shaded.pixel.column, 0, rules.viewport.width - 1);
        shaded.pixel.row = std::clamp(shaded.pixel.row, 0, rules.viewport.height - 1);
    }
    if (rules.behind_camera == BehindCamera::mark_minus_one && shaded.pixel.column == -1) {
        shaded.fault = VertexFault::taken_for_behind;
    }
    shaded.pixel.zinv = zinv;
    shaded.pixel.z = z;
    shaded.pixel.varyings = start_varyings(vertex, zinv, rules, stages);
    return shaded;
}

} // namespace rasterwalk
