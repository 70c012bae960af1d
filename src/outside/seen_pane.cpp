#include "outside/seen_pane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "outside/seen_box.h"

namespace rasterwalk {

namespace {

/// Below this cosine between its normal and the way to it, a pane is seen edge-on: the pixel under
/// a sample is then not accurate enough to say where it is seen.
constexpr double smallest_cosine = 1e-4;

bool is_seen_along(const SeenPane& pane) {
    const glm::dvec3 normal = glm::cross(pane.right, pane.down);
    const double cosine = std::abs(glm::dot(normal, pane.corners[0])) /
                          (glm::length(normal) * glm::length(pane.corners[0]));
    return !(cosine > smallest_cosine);
}

} // namespace

std::optional<SeenPane> seen_pane(const PicturePlane& plane, const OutsideEye& eye) {
    const Viewport size = plane.size;
    if (size.width < 1 || size.height < 1) return std::nullopt;
    SeenPane pane{.corners = plane.corners()};
    auto& corners = pane.corners;
    for (glm::dvec3& corner : corners)
        corner = eye.seen(corner);
    if (std::none_of(corners.begin(), corners.end(),
                     [&](const glm::dvec3& corner) { return corner.z >= eye.near_distance; }))
        return std::nullopt;
    pane.right = (corners[1] - corners[0]) / static_cast<double>(size.width);
    pane.down = (corners[3] - corners[0]) / static_cast<double>(size.height);
    pane.across = pane.right / glm::dot(pane.right, pane.right);
    pane.along = pane.down / glm::dot(pane.down, pane.down);
    const glm::dvec3 normal = glm::cross(pane.right, pane.down);
    pane.inv_z = normal / glm::dot(normal, pane.corners[0]);
    pane.samples_a_pixel =
        eye.focal_length * glm::length(pane.right) /
        std::max(0.25 * (corners[0].z + corners[1].z + corners[2].z + corners[3].z),
                 eye.near_distance);
    return pane;
}

Rectangle box_of_pixels(const SeenPane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area) {
    if (is_empty(pixels)) return {};
    const Rectangle whole = box_around(eye, pane.corners, area);
    if (is_seen_along(pane)) return whole;
    // A point at the border of a pixel may count as its neighbour's.
    const auto place = [&](int column, int row) {
        return pane.corners[0] + static_cast<double>(column) * pane.right +
               static_cast<double>(row) * pane.down;
    };
    const std::array<glm::dvec3, 4> corners{
        place(pixels.left - 1, pixels.top - 1), place(pixels.right + 1, pixels.top - 1),
        place(pixels.right + 1, pixels.bottom + 1), place(pixels.left - 1, pixels.bottom + 1)};
    return box_around(eye, corners, whole);
}

} // namespace rasterwalk
