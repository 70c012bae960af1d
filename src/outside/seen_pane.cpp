#include "outside/seen_pane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

namespace rasterwalk {

namespace {

/// Below this cosine between the pane's normal and the way to it a pane is seen along itself: the
/// pixel under a sample is then worked out with too little accuracy to say where it is seen.
constexpr double smallest_cosine = 1e-4;

bool is_seen_along(const SeenPane& pane) {
    const glm::dvec3 normal = glm::cross(pane.right, pane.down);
    const double cosine =
        std::abs(glm::dot(normal, pane.corner)) / (glm::length(normal) * glm::length(pane.corner));
    return !(cosine > smallest_cosine);
}

} // namespace

std::optional<SeenPane> seen_pane(const PicturePlane& plane, const OutsideEye& eye) {
    const Viewport size = plane.size;
    if (size.width < 1 || size.height < 1) return std::nullopt;
    std::array<glm::dvec3, 4> corners = plane.corners();
    for (glm::dvec3& corner : corners)
        corner = eye.seen(corner);
    SeenPane pane;
    pane.polygon = clipped_to_near(corners, eye.near_distance);
    if (pane.polygon.count < triangle_corners) return std::nullopt;
    pane.corner = corners[0];
    pane.right = (corners[1] - corners[0]) / static_cast<double>(size.width);
    pane.down = (corners[3] - corners[0]) / static_cast<double>(size.height);
    pane.across = pane.right / glm::dot(pane.right, pane.right);
    pane.along = pane.down / glm::dot(pane.down, pane.down);
    pane.samples_a_pixel =
        eye.focal_length * glm::length(pane.right) /
        std::max(0.25 * (corners[0].z + corners[1].z + corners[2].z + corners[3].z),
                 eye.near_distance);
    return pane;
}

Rectangle box_of_pixels(const SeenPane& pane, const OutsideEye& eye, const Rectangle& pixels,
                        const Rectangle& area) {
    if (is_empty(pixels)) return {};
    const Rectangle whole = box_around(eye, pane.polygon.all(), area);
    if (is_seen_along(pane)) return whole;
    // What is seen at the border of a pixel may count to its neighbour.
    const auto place = [&](int column, int row) {
        return pane.corner + static_cast<double>(column) * pane.right +
               static_cast<double>(row) * pane.down;
    };
    const std::array<glm::dvec3, 4> corners{
        place(pixels.left - 1, pixels.top - 1), place(pixels.right + 1, pixels.top - 1),
        place(pixels.right + 1, pixels.bottom + 1), place(pixels.left - 1, pixels.bottom + 1)};
    const SeenPolygon seen = clipped_to_near(corners, eye.near_distance);
    return seen.count < triangle_corners ? Rectangle{} : box_around(eye, seen.all(), whole);
}

} // namespace rasterwalk
