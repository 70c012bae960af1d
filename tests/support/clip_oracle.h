#pragma once

// Clipping a second way: in barycentric coordinates of the triangle and in double. A distance from
// a plane is linear in them, so no corner need be computed on the way.

#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/frame.h"

namespace rasterwalk::test {

struct OracleClip {
    std::vector<glm::dvec3> corners; ///< shares of the triangle's three
    std::array<int, 6> steps{};      ///< tested edges by plane: near, far, left, right, top, bottom
    bool is_cut = false;
    bool is_gone = false;
    /// How near a corner comes to a plane, and how flat an edge meets one, as a part of the size of
    /// the numbers: what is nearly 0 may turn out differently in float.
    double least = INFINITY;
};

/// a + b x + ... of a plane, in double, with the sum of the sizes of its parts.
struct OraclePlane {
    glm::dvec4 coefficients;
    double at(const glm::dvec4& p) const { return glm::dot(coefficients, p); }
    double size(const glm::dvec4& p) const { return glm::dot(glm::abs(coefficients), glm::abs(p)); }
};

/// The planes that cut under these settings: none, one or six.
inline std::vector<OraclePlane> oracle_planes(const Settings& settings, SceneSpace space) {
    if (space == SceneSpace::pixels) return {};
    if (settings.clip == Clip::leave_out || settings.clip == Clip::none) return {};
    const double near = settings.near, far = settings.far;
    std::vector<OraclePlane> planes{{{0, 0, -near, 1}}};
    if (settings.clip == Clip::near) return planes;
    double left = settings.viewport.width / 2, top = settings.viewport.height / 2;
    double right = settings.viewport.width - left, bottom = settings.viewport.height - top;
    if (settings.clip == Clip::guard_band) left = right = top = bottom = 8192.0;
    planes.push_back({{0, 0, far, -1}});
    planes.push_back({{1, 0, 0, left}});
    planes.push_back({{-1, 0, 0, right}});
    planes.push_back({{0, 1, 0, top}});
    planes.push_back({{0, -1, 0, bottom}});
    return planes;
}

inline OracleClip oracle_clip(const std::array<glm::dvec4, 3>& triangle,
                              const std::vector<OraclePlane>& planes) {
    OracleClip clip;
    clip.corners = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t p = 0; p < planes.size(); ++p) {
        glm::dvec3 distance;
        double size = 0.0;
        for (int i = 0; i < 3; ++i) {
            distance[i] = planes[p].at(triangle[static_cast<std::size_t>(i)]);
            size = std::max(size, planes[p].size(triangle[static_cast<std::size_t>(i)]));
        }
        bool is_any_outside = false, is_any_within = false;
        for (const glm::dvec3& corner : clip.corners) {
            const double d = glm::dot(corner, distance);
            clip.least = std::min(clip.least, std::abs(d) / size);
            is_any_outside = is_any_outside || !(d >= 0.0);
            is_any_within = is_any_within || d > 0.0;
        }
        if (!is_any_outside) continue;
        clip.is_cut = true;
        clip.steps[p] = static_cast<int>(clip.corners.size());
        std::vector<glm::dvec3> left;
        for (std::size_t i = 0; i < clip.corners.size(); ++i) {
            const glm::dvec3 &a = clip.corners[i], &b = clip.corners[(i + 1) % clip.corners.size()];
            const double d_a = glm::dot(a, distance), d_b = glm::dot(b, distance);
            if (d_a >= 0.0) left.push_back(a);
            if ((d_a >= 0.0) == (d_b >= 0.0)) continue;
            clip.least = std::min(clip.least, std::abs(d_a - d_b) / size);
            left.push_back((a * d_b - b * d_a) / (d_b - d_a));
        }
        clip.corners = left;
        if (!is_any_within) {
            clip.is_gone = true;
            break;
        }
    }
    return clip;
}

inline OracleClip oracle_clip(const Frame& frame, int triangle) {
    std::array<glm::dvec4, 3> corners;
    for (int i = 0; i < 3; ++i)
        corners[static_cast<std::size_t>(i)] = frame.given_clip_vertex(triangle, i).position_clip;
    return oracle_clip(corners, oracle_planes(frame.settings, frame.scene->space));
}

} // namespace rasterwalk::test
