#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// A line between two points in the world.
struct OutlineEdge {
    glm::vec3 from{0.0f}, to{0.0f};
};

/// The edges that show the shape of a scene: those between triangles of different parts or
/// directions, and those that only one triangle has, but not the joint between two halves of a flat
/// wall. Empty for a scene of more than `most_outlined` triangles, which needs no lines.
std::vector<OutlineEdge> outline_of(const Scene& scene);

inline constexpr int most_outlined = 10'000;

} // namespace rasterwalk
