#include "stages/vertex_shader.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "stages/orthographic.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A vertex before the camera.
struct CameraPlace {
    glm::vec3 minus_camera; ///< the camera stands at the origin
    glm::vec3 rotated;      ///< and looks along +z
    glm::vec4 clip;
};

CameraPlace seen_by_camera(const glm::vec3& position_world, const glm::mat3& rotation,
                           const VertexRules& rules, const Stages& stages) {
    CameraPlace place;
    place.minus_camera = position_world - rules.camera.position;
    place.rotated = stages.rotate_to_camera(place.minus_camera, rotation);
    place.clip = stages.to_clip_space(place.rotated, rules);
    return place;
}

/// The direction, or the other one if it has no length.
glm::vec3 unit_or(const glm::vec3& direction, const glm::vec3& other) {
    // In double, so that the square of a small length is not 0.
    const glm::dvec3 wide(direction);
    const double length = glm::length(wide);
    return length > 0.0 ? glm::vec3(wide / length) : other;
}

/// In a scene in pixel space x and y are columns and rows already: there is no camera.
CameraPlace given_in_pixels(const glm::vec3& position, const VertexRules& rules) {
    return {position, position, {position.x, position.y, clip_z(position.z, rules), position.z}};
}

} // namespace

glm::mat3 look_at_rotation(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
    const glm::vec3 forward = unit_or(target - eye, {0.0f, 0.0f, 1.0f});
    const auto across = [&](const glm::vec3& direction) {
        // What is left of it is rubbish of rounding if it points along the view.
        constexpr float smallest_sine = 1e-6f;
        const glm::vec3 right = glm::cross(forward, unit_or(direction, glm::vec3(0.0f)));
        return glm::length(right) > smallest_sine ? right : glm::vec3(0.0f);
    };
    // y runs down: right, down and forward go round as x, y and z do.
    const glm::vec3 beside =
        std::abs(forward.y) < 0.9f ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, -1.0f);
    const glm::vec3 right = unit_or(across(up), unit_or(across(beside), {1.0f, 0.0f, 0.0f}));
    return {right, glm::cross(forward, right), forward};
}

glm::mat3 camera_rotation(const Camera& camera) {
    if (camera.aim == CameraAim::look_at)
        return look_at_rotation(camera.position, camera.target, camera.up);
    const float cy = std::cos(camera.yaw), sy = std::sin(camera.yaw);
    const float cp = std::cos(camera.pitch), sp = std::sin(camera.pitch);
    // Columns are the camera's right, down and forward axes in the world.
    const glm::vec3 right(cy, 0.0f, -sy);
    const glm::vec3 down(sp * sy, cp, sp * cy);
    const glm::vec3 forward(cp * sy, -sp, cp * cy);
    return {right, down, forward};
}

Varyings start_varyings(const Vertex& vertex, const VertexRules& rules, const Stages& stages) {
    Varyings varyings;
    varyings.position_world = vertex.position;
    varyings.normal = vertex.normal;
    varyings.colour = vertex.reflectance;
    varyings.texcoord = vertex.texcoord;
    if (rules.shading == Shading::gouraud) {
        varyings.illumination =
            stages
                .reflected_light(vertex.position, stages.light_normal(vertex.normal, rules.camera),
                                 vertex.reflectance, rules.light)
                .reflected;
    }
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
    const CameraPlace place = rules.space == SceneSpace::world
                                  ? seen_by_camera(vertex.position, rotation, rules, stages)
                                  : given_in_pixels(vertex.position, rules);
    if (spaces != nullptr) {
        spaces->add("world", vertex.position);
        spaces->add("minus_camera", place.minus_camera);
        spaces->add("rotated", place.rotated);
    }
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    const glm::vec4 clip = is_finite(place.rotated) ? place.clip : glm::vec4(not_a_number);
    return {clip, start_varyings(vertex, rules, stages)};
}

} // namespace rasterwalk
