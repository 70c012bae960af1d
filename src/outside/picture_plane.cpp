#include "outside/picture_plane.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "stages/project.h"

namespace rasterwalk {

namespace {

/// The distance of the picture from the eye, and the largest half of its diagonal, radii of the
/// scene.
constexpr double usual_distance = 0.5;
constexpr double largest_half_diagonal = 0.6;

} // namespace

glm::dvec3 PicturePlane::place_of(const glm::dvec2& pixel) const {
    const glm::dvec2 projected = pixel - middle;
    return in_world({w_at(distance) / scale * projected, distance});
}

std::optional<glm::dvec2> PicturePlane::pixel_of(const glm::dvec3& camera) const {
    const double w = w_at(camera.z);
    if (!(w > 0.0)) return std::nullopt;
    const glm::dvec2 pixel = middle + scale * glm::dvec2(camera.x / w, camera.y / w);
    return std::isfinite(pixel.x) && std::isfinite(pixel.y) ? std::optional(pixel) : std::nullopt;
}

std::array<glm::dvec3, 4> PicturePlane::corners() const {
    const double width = size.width, height = size.height;
    return {place_of({0.0, 0.0}), place_of({width, 0.0}), place_of({width, height}),
            place_of({0.0, height})};
}

PicturePlane picture_plane(const Camera& camera, const Viewport& size, const SceneBox& box,
                           const Projection& projection) {
    PicturePlane plane;
    plane.eye = camera.position;
    plane.rotation = camera_rotation(camera);
    plane.size = size;
    plane.mix = projection.mix;
    Projection drawn = projection;
    drawn.depth = std::max(projection.depth, 1e-6f);
    constexpr float least = 1e-3f; // no division by 0
    const float focal_length = std::max(camera.focal_length, least);
    const PictureScale picture = picture_scale(focal_length, size, drawn);
    plane.scale = picture.scale;
    plane.shift = picture.shift;
    // Under any other projection no eye sees exactly what the picture shows.
    plane.focal_length =
        plane.mix == 0.0 ? glm::max(plane.scale, glm::dvec2(least)) : glm::dvec2(focal_length);
    VertexRules rules;
    rules.viewport = size;
    plane.middle = glm::dvec2(viewport_middle(rules)) + picture.shift;
    const double half_diagonal =
        0.5 * std::hypot(static_cast<double>(size.width), static_cast<double>(size.height));
    const double radius = box.radius();
    plane.distance =
        radius * std::min(usual_distance, largest_half_diagonal *
                                              std::min(plane.focal_length.x, plane.focal_length.y) /
                                              std::max(half_diagonal, 1.0));
    return plane;
}

} // namespace rasterwalk
