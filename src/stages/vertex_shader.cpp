#include "stages/vertex_shader.h"

#include <cmath>
#include <limits>

#include "base/sine.h"
#include "scene/look_at.h"
#include "stages/orthographic.h"
#include "stages/stage_table.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A vertex as the camera sees it.
struct CameraVertex {
    CameraPlace place;
    glm::vec4 clip;
};

CameraVertex to_camera_vertex(const glm::vec3& position_world, const glm::mat3& rotation,
                              const VertexRules& rules, const Stages& stages) {
    CameraVertex camera_vertex;
    camera_vertex.place = call<to_camera_space>(stages.to_camera_space, position_world,
                                                rules.camera, rotation, stages);
    camera_vertex.clip = stages.to_clip_space(camera_vertex.place.rotated, rules);
    return camera_vertex;
}

/// In a scene in pixel space x and y are already columns and rows: there is no camera.
CameraVertex given_in_pixels(const glm::vec3& position, const VertexRules& rules) {
    return {{position, position}, {position.x, position.y, clip_z(position.z, rules), position.z}};
}

} // namespace

glm::mat3 camera_rotation(const Camera& camera) {
    if (camera.aim == CameraAim::look_at)
        return look_at_rotation(camera.position, camera.target, camera.up);
    const float cy = cosine(camera.yaw), sy = sine(camera.yaw);
    const float cp = cosine(camera.pitch), sp = sine(camera.pitch);
    // Columns are the camera's right, down and forward axes in the world.
    const glm::vec3 right(cy, 0.0f, -sy);
    const glm::vec3 down(sp * sy, cp, sp * cy);
    const glm::vec3 forward(cp * sy, -sp, cp * cy);
    return {right, down, forward};
}

CameraPlace to_camera_space(const glm::vec3& position_world, const Camera& camera,
                            const glm::mat3& rotation, const Stages& stages) {
    const glm::vec3 minus_camera = position_world - camera.position;
    return {minus_camera, stages.rotate_to_camera(minus_camera, rotation)};
}

SurfaceLight light_at_vertex(const Vertex& vertex, const VertexRules& rules, const Stages& stages) {
    const glm::vec3 normal = stages.light_normal(vertex.normal, rules.camera);
    const SurfacePoint point{vertex.position, normal, vertex.reflectance, vertex.shine};
    // The camera's direction costs sines, and only highlights and lit backs need it.
    const bool needs_sight_rays =
        rules.light.model != LightModel::lambert || stages.light_side != side_of_normal;
    const SightRays rays = needs_sight_rays ? sight_rays(rules) : SightRays{};
    return surface_light(on_lit_side(point, rays, stages), rules.light, rays, rules.occluders,
                         stages);
}

Varyings start_varyings(const Vertex& vertex, const VertexRules& rules, const Stages& stages) {
    Varyings varyings;
    varyings.position_world = vertex.position;
    varyings.normal = vertex.normal;
    varyings.colour = vertex.reflectance;
    varyings.texcoord = vertex.texcoord;
    if (rules.shading == Shading::gouraud)
        varyings.illumination = light_at_vertex(vertex, rules, stages).reflected;
    return varyings;
}

glm::vec3 VertexSpaces::in(std::string_view space) const {
    for (const SpacePoint& point : points) {
        if (point.space == space) return point.place;
    }
    return glm::vec3(0.0f);
}

ClipVertex vertex_shader(const Vertex& vertex, const glm::mat3& rotation, const VertexRules& rules,
                         const Stages& stages, VertexSpaces* spaces) {
    const CameraVertex camera_vertex =
        rules.space == SceneSpace::world
            ? to_camera_vertex(vertex.position, rotation, rules, stages)
            : given_in_pixels(vertex.position, rules);
    if (spaces != nullptr) {
        spaces->add("world", vertex.position);
        spaces->add("minus_camera", camera_vertex.place.minus_camera);
        spaces->add("rotated", camera_vertex.place.rotated);
    }
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const glm::vec4 clip =
        is_finite(camera_vertex.place.rotated) ? camera_vertex.clip : glm::vec4(not_a_number);
    return {clip, start_varyings(vertex, rules, stages)};
}

} // namespace rasterwalk
