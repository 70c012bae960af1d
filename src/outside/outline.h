#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// A line between two places of the world.
struct OutlineEdge {
    glm::vec3 from{0.0f}, to{0.0f};
};

/// The edges by which the shape of a scene is seen: those between triangles of different parts or
/// directions, and those that only one triangle has. What joins two halves of a flat wall is not
/// among them. Empty for a scene of more triangles than `most_outlined`, which needs no lines.
std::vector<OutlineEdge> outline_of(const Scene& scene);

inline constexpr int most_outlined = 10'000;

} // namespace rasterwalk
