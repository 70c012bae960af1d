#include "scene/averaged_normals.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// Where unit normals cancel, rounding leaves a sum that is shorter than this.
constexpr double shortest_sum = 1e-9;

} // namespace

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void AveragedNormals::add(const TriangleIndices& points,
                          const std::array<glm::vec3, triangle_corners>& positions) {
    // In double, so that the product of two small lengths is not 0.
    std::array<glm::dvec3, triangle_corners> places;
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = glm::dvec3(positions[i]);
    const glm::dvec3 across = glm::cross(places[2] - places[0], places[1] - places[0]);
    const double length = glm::length(across);
    if (!(length > 0.0)) return;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const glm::dvec3 next = places[(i + 1) % places.size()] - places[i];
        const glm::dvec3 other = places[(i + 2) % places.size()] - places[i];
        sums_.try_emplace(points[i], 0.0).first->second +=
            across * (angle_between(next, other) / length);
    }
}

glm::vec3 AveragedNormals::at(int point, const glm::vec3& face) const {
    const auto found = sums_.find(point);
    if (found == sums_.end()) return face;
    const double length = glm::length(found->second);
    return length > shortest_sum ? glm::vec3(found->second / length) : face;
}

} // namespace rasterwalk
