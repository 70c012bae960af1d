#include "scene/obj_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/limits.h"
#include "scene/averaged_normals.h"
#include "scene/polygon_cutter.h"

namespace rasterwalk {

namespace {

glm::vec3 unit_or_zero(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    return length > 0.0 ? glm::vec3(direction / length) : glm::vec3(0.0f);
}

/// Normals of faces, and the angle of each corner.
struct Faces {
    std::vector<glm::vec3> normals; ///< unit length, or zero
    std::vector<int> face_of;       ///< each corner
    std::vector<float> angles;      ///< each corner, radians
};

Faces measure(const FaceCorners& faces, std::span<const glm::vec3> points, bool wants_angles) {
    Faces measured;
    measured.face_of.resize(faces.positions.size());
    measured.angles.resize(wants_angles ? faces.positions.size() : 0);
    std::vector<glm::vec3> corners;
    for (std::size_t face = 0; face + 1 < faces.first_corner.size(); ++face) {
        const auto first = static_cast<std::size_t>(faces.first_corner[face]);
        const auto count = static_cast<std::size_t>(faces.first_corner[face + 1]) - first;
        corners.clear();
        for (std::size_t i = 0; i < count; ++i) {
            corners.push_back(points[static_cast<std::size_t>(faces.positions[first + i])]);
            measured.face_of[first + i] = static_cast<int>(face);
        }
        measured.normals.push_back(unit_or_zero(newell_normal(corners)));
        for (std::size_t i = 0; wants_angles && i < count; ++i) {
            const glm::dvec3 here(corners[i]);
            measured.angles[first + i] = static_cast<float>(
                angle_between(glm::dvec3(corners[(i + 1) % count]) - here,
                              glm::dvec3(corners[(i + count - 1) % count]) - here));
        }
    }
    return measured;
}

} // namespace

std::vector<glm::vec3> corner_normals(const FaceCorners& faces, std::span<const glm::vec3> points,
                                      float crease_angle) {
    const bool smooths = crease_angle > 0.0f;
    const Faces measured = measure(faces, points, smooths);
    const auto face_normal_of = [&](int corner) {
        const int face = measured.face_of[static_cast<std::size_t>(corner)];
        return measured.normals[static_cast<std::size_t>(face)];
    };
    const int corner_count = static_cast<int>(faces.positions.size());
    std::vector<glm::vec3> normals;
    normals.reserve(faces.positions.size());
    for (int i = 0; i < corner_count; ++i)
        normals.push_back(face_normal_of(i));
    if (!smooths) return normals;

    // The corners at each point, point by point.
    std::vector<int> begin(points.size() + 1, 0);
    for (const int point : faces.positions)
        ++begin[static_cast<std::size_t>(point) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i)
        begin[i] += begin[i - 1];
    std::vector<int> corners(faces.positions.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (int i = 0; i < corner_count; ++i) {
        const auto point = static_cast<std::size_t>(faces.positions[static_cast<std::size_t>(i)]);
        corners[static_cast<std::size_t>(next[point]++)] = i;
    }

    const float least_cosine = std::cos(crease_angle);
    for (std::size_t point = 0; point < points.size(); ++point) {
        if (begin[point + 1] - begin[point] > most_smoothed_faces) continue;
        const std::span<const int> here(corners.data() + begin[point],
                                        corners.data() + begin[point + 1]);
        for (const int corner : here) {
            const glm::vec3 own = face_normal_of(corner);
            glm::dvec3 sum(0.0);
            for (const int other : here) {
                const glm::vec3 normal = face_normal_of(other);
                if (glm::dot(own, normal) < least_cosine && other != corner) continue;
                const float angle = measured.angles[static_cast<std::size_t>(other)];
                sum += static_cast<double>(angle) * glm::dvec3(normal);
            }
            const glm::vec3 smooth = unit_or_zero(sum);
            if (smooth != glm::vec3(0.0f)) normals[static_cast<std::size_t>(corner)] = smooth;
        }
    }
    return normals;
}

} // namespace rasterwalk
