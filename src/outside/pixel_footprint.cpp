#include "outside/pixel_footprint.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace rasterwalk {

std::optional<FootprintCorners>
pixel_footprint(const PicturePlane& plane, const std::array<glm::dvec3, triangle_corners>& triangle,
                glm::ivec2 pixel) {
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const std::array<glm::dvec2, 4> corners{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1),
                                            glm::dvec2(0, 1)};
    FootprintCorners footprint;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 in_view = plane.in_camera(plane.place_of(glm::dvec2(pixel) + corners[i]));
        // Two points of the ray: on the picture, and where z is 0.
        const glm::dvec3 near = plane.in_world(plane.on_ray(in_view, 0.0));
        const glm::dvec3 on_picture = plane.in_world(in_view);
        const double share =
            glm::dot(normal, triangle[0] - near) / glm::dot(normal, on_picture - near);
        const glm::dvec3 met = near + share * (on_picture - near);
        if (!std::isfinite(share) || !(plane.w_at(plane.in_camera(met).z) > 0.0))
            return std::nullopt;
        footprint[i] = met;
    }
    return footprint;
}

} // namespace rasterwalk
