#include "scene/look_at.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// The unit direction, or the other one if it has no length.
glm::vec3 unit_or(const glm::vec3& direction, const glm::vec3& other) {
    // In double, so that the square of a small length is not 0.
    const glm::dvec3 wide(direction);
    const double length = glm::length(wide);
    return length > 0.0 ? glm::vec3(wide / length) : other;
}

glm::vec3 forward_to(const glm::vec3& eye, const glm::vec3& target) {
    return unit_or(target - eye, {0.0f, 0.0f, 1.0f});
}

/// Perpendicular to both; zero if one points along the other.
glm::vec3 across(const glm::vec3& forward, const glm::vec3& direction) {
    // Along the view, only rounding errors are left.
    constexpr float smallest_sine = 1e-6f;
    const glm::vec3 right = glm::cross(forward, unit_or(direction, glm::vec3(0.0f)));
    return glm::length(right) > smallest_sine ? right : glm::vec3(0.0f);
}

} // namespace

glm::mat3 look_at_rotation(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
    const glm::vec3 forward = forward_to(eye, target);
    // y runs down: right, down and forward go round as x, y and z do.
    const glm::vec3 sideways =
        std::abs(forward.y) < 0.9f ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, -1.0f);
    const glm::vec3 right =
        unit_or(across(forward, up), unit_or(across(forward, sideways), {1.0f, 0.0f, 0.0f}));
    return {right, glm::cross(forward, right), forward};
}

AimFault aim_fault(const Camera& camera) {
    if (camera.aim != CameraAim::look_at) return AimFault::none;
    if (camera.target == camera.position) return AimFault::no_way;
    const glm::vec3 forward = forward_to(camera.position, camera.target);
    return across(forward, camera.up) == glm::vec3(0.0f) ? AimFault::no_up : AimFault::none;
}

} // namespace rasterwalk
