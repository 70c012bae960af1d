#include "scene/scene_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

constexpr double smallest_radius = 1e-3;

} // namespace

double SceneBox::radius() const {
    return std::max(0.5 * glm::length(high - low), smallest_radius);
}

SceneBox box_of(const Scene& scene) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    SceneBox box{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const Vertex& vertex : scene.mesh.vertices()) {
        const glm::dvec3 place(vertex.position);
        if (!std::isfinite(place.x + place.y + place.z)) continue;
        box.low = glm::min(box.low, place);
        box.high = glm::max(box.high, place);
    }
    return box.low.x <= box.high.x ? box : SceneBox();
}

} // namespace rasterwalk
