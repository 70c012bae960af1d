#pragma once

// What all rungs of the ladder share, so that each file has only what the eye should meet.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engines/ladder/ladder_picture.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk::rungs {

inline constexpr float pi = 3.14159265f;

/// The lab's global variables.
struct Lab {
    glm::vec3 eye{0.0f};       ///< where the camera is, world units; it looks along +z
    float focal_length = 0.0f; ///< pixels
    Light light;
    bool is_light_per_vertex = false;
    LadderPicture& picture;
};

/// Those of the settings, and a black picture.
inline Lab begin_picture(const Settings& settings, LadderPicture& picture) {
    picture.clear(settings.viewport);
    return {settings.camera.position, settings.camera.focal_length, settings.light,
            settings.shading == Shading::gouraud, picture};
}

/// What is the same at all pixels of a triangle.
struct Surface {
    glm::vec3 normal{0.0f}; ///< of the first corner
    glm::vec3 reflectance{0.0f};
    bool is_bent = false; ///< its corners have different normals
};

inline Surface surface_of(const std::array<Vertex, triangle_corners>& corners) {
    const auto& [a, b, c] = corners;
    return {a.normal, a.reflectance, a.normal != b.normal || a.normal != c.normal};
}

/// What reaches a point from the lamp and from all around.
inline glm::vec3 light_at(const glm::vec3& position, const glm::vec3& normal, const Light& light) {
    const glm::vec3 to_light = light.position - position;
    const float distance2 = glm::dot(to_light, to_light);
    const float cosine = std::max(0.0f, glm::dot(to_light, normal) / std::sqrt(distance2));
    return light.power * (cosine / (4.0f * pi * distance2)) + light.indirect;
}

/// A channel as a byte; black for a number that is none.
inline std::uint32_t to_byte(float channel) {
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(std::min(std::max(0.0f, 255.0f * channel), 255.0f)));
}

/// 0x00RRGGBB
inline std::uint32_t to_bytes(const glm::vec3& colour) {
    return to_byte(colour.r) << 16 | to_byte(colour.g) << 8 | to_byte(colour.b);
}

/// Where a pixel is in the planes of a picture.
inline std::size_t place_of(int column, int row, Viewport size) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
           static_cast<std::size_t>(column);
}

} // namespace rasterwalk::rungs
