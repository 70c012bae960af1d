#include "support/ray_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "support/ray_caster.h"

namespace rasterwalk::test {

namespace {

/// A triangle in front of the camera's eye: x to the right, y down, z forward.
struct CameraTriangle {
    int number = -1;      ///< in the scene
    glm::dmat3 sides;     ///< of the pyramid that eye and triangle make; inward
    glm::dvec3 zinv;      ///< its product with a ray (x, y, 1) is 1/z where the two meet
    glm::dvec2 low, high; ///< the box of what is seen of it, pixels from the left top
};

struct Picture {
    Viewport size;
    double focal_length = 0.0, margin = 0.0;
    glm::dvec2 middle{0.0}; ///< pixels from the left top

    glm::dvec2 pixel_at(const glm::dvec3& p) const {
        return middle + focal_length / p.z * glm::dvec2(p);
    }
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(column);
    }
};

/// The pixels of a row or a column whose centres are from `low` to `high`.
struct Pixels {
    int first = 0, end = 0;
};
Pixels pixels_between(double low, double high, int count) {
    return {static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, 1.0 * count))),
            static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, count - 1.0))) + 1};
}

/// Marks the pixels whose centres lie within the margin of a line. Row by row, next to the part of
/// the line that is within the margin of the row.
void mark_outline(const Picture& picture, glm::dvec2 from, glm::dvec2 to, std::vector<int>& met) {
    if (from.y > to.y) std::swap(from, to);
    const double margin = picture.margin;
    const Pixels rows = pixels_between(from.y - margin, to.y + margin, picture.size.height);
    for (int row = rows.first; row < rows.end; ++row) {
        const double y = row + 0.5;
        double x[2] = {from.x, to.x};
        if (from.y < to.y) {
            const double slope = (to.x - from.x) / (to.y - from.y);
            x[0] = from.x + slope * (std::max(y - margin, from.y) - from.y);
            x[1] = from.x + slope * (std::min(y + margin, to.y) - from.y);
        }
        const auto [left, right] = std::minmax(x[0], x[1]);
        const Pixels columns = pixels_between(left - margin, right + margin, picture.size.width);
        for (int column = columns.first; column < columns.end; ++column) {
            if (distance_to_segment({column + 0.5, y}, from, to) <= margin)
                met[picture.at(column, row)] = ray_near_outline;
        }
    }
}

/// Removes the part of a convex polygon nearer than the depth, side 1, or farther, side -1.
void cut_at_depth(std::vector<glm::dvec3>& polygon, double depth, double side) {
    std::vector<glm::dvec3> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double beyond_p = side * (p.z - depth), beyond_q = side * (q.z - depth);
        if (beyond_p >= 0.0) left.push_back(p);
        if ((beyond_p >= 0.0) == (beyond_q >= 0.0)) continue;
        left.push_back(glm::mix(p, q, beyond_p / (beyond_p - beyond_q)));
    }
    polygon.swap(left);
}

/// The triangle in the form that rays use. If its plane goes through the eye, no ray meets it.
void add_triangle(int number, const glm::dvec3 (&p)[3], glm::dvec2 low, glm::dvec2 high,
                  std::vector<CameraTriangle>& triangles) {
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double volume = glm::dot(normal, p[0]); // six times that of eye and triangle
    if (volume == 0.0) return;
    const double inward = volume > 0.0 ? 1.0 : -1.0;
    triangles.push_back({number,
                         {inward * glm::cross(p[0], p[1]), inward * glm::cross(p[1], p[2]),
                          inward * glm::cross(p[2], p[0])},
                         normal / volume,
                         low,
                         high});
}

int first_met(const Picture& picture, const std::vector<CameraTriangle>& triangles,
              DepthRange depths, glm::dvec2 place) {
    const glm::dvec3 ray((place - picture.middle) / picture.focal_length, 1.0);
    int met = ray_meets_nothing;
    double nearest = 1.0 / depths.far;
    for (const CameraTriangle& triangle : triangles) {
        if (place.x < triangle.low.x || place.x > triangle.high.x || place.y < triangle.low.y ||
            place.y > triangle.high.y)
            continue;
        const double zinv = glm::dot(triangle.zinv, ray);
        if (!(zinv > nearest && zinv < 1.0 / depths.near)) continue;
        if (glm::dot(triangle.sides[0], ray) < 0.0 || glm::dot(triangle.sides[1], ray) < 0.0 ||
            glm::dot(triangle.sides[2], ray) < 0.0)
            continue;
        nearest = zinv;
        met = triangle.number;
    }
    return met;
}

} // namespace

std::vector<int> cast_rays(const Scene& scene, const Camera& camera, Viewport size,
                           DepthRange depths, double margin) {
    Picture picture{size, camera.focal_length, margin};
    picture.middle = {size.width / 2, size.height / 2}; // whole pixels, as in the lab
    std::vector<int> met(picture.at(0, size.height), ray_meets_nothing);
    const CameraAxes axes = camera_axes(camera);
    std::vector<CameraTriangle> triangles;
    std::vector<glm::dvec3> seen;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        glm::dvec3 p[3];
        for (int v = 0; v < 3; ++v) {
            const glm::dvec3 way =
                glm::dvec3(scene.corner(t, v).position) - glm::dvec3(camera.position);
            p[v] = {glm::dot(way, axes.right), glm::dot(way, axes.down),
                    glm::dot(way, axes.forward)};
        }
        seen.assign(p, p + 3);
        cut_at_depth(seen, depths.near, 1.0);
        cut_at_depth(seen, depths.far, -1.0);
        glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const glm::dvec2 from = picture.pixel_at(seen[i]);
            low = glm::min(low, from);
            high = glm::max(high, from);
            mark_outline(picture, from, picture.pixel_at(seen[(i + 1) % seen.size()]), met);
        }
        if (high.x > 0.0 && low.x < size.width && high.y > 0.0 && low.y < size.height)
            add_triangle(t, p, low, high, triangles);
    }
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            int& of_pixel = met[picture.at(column, row)];
            if (of_pixel == ray_near_outline) continue;
            of_pixel = first_met(picture, triangles, depths, {column + 0.5, row + 0.5});
        }
    }
    return met;
}

} // namespace rasterwalk::test
