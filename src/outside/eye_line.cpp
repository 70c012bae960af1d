#include "outside/eye_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/common.hpp>

namespace rasterwalk {

namespace {

/// A line on a surface must win against the surface, which is equally near.
constexpr double line_bias = 1.002;

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

EyeLine eye_line(const OutsideEye& eye, glm::dvec3 from, glm::dvec3 to) {
    EyeLine line;
    if (!is_finite(from) || !is_finite(to)) return line;
    const double near_distance = eye.near_distance;
    if (from.z < near_distance && to.z < near_distance) return line;
    if (from.z < near_distance || to.z < near_distance) {
        const glm::dvec3 cut = glm::mix(from, to, (near_distance - from.z) / (to.z - from.z));
        glm::dvec3& hidden = from.z < near_distance ? from : to;
        hidden = {cut.x, cut.y, near_distance};
    }
    line.from = eye.pixel(from);
    line.to = eye.pixel(to);
    line.inv_z_from = 1.0 / from.z;
    line.inv_z_to = 1.0 / to.z;
    line.is_seen = std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y);
    return line;
}

EyeLine clipped_to(const EyeLine& line, glm::dvec2 low, glm::dvec2 high) {
    // Liang and Barsky: each side of the rectangle leaves a range of the line.
    double begin = 0.0, end = 1.0;
    const glm::dvec2 delta = line.to - line.from;
    bool is_outside = !line.is_seen;
    for (int axis = 0; axis < 2; ++axis) {
        if (delta[axis] == 0.0) {
            is_outside |= line.from[axis] < low[axis] || line.from[axis] > high[axis];
            continue;
        }
        double enters = (low[axis] - line.from[axis]) / delta[axis];
        double leaves = (high[axis] - line.from[axis]) / delta[axis];
        if (enters > leaves) std::swap(enters, leaves);
        begin = std::max(begin, enters);
        end = std::min(end, leaves);
    }
    EyeLine part;
    if (is_outside || !(begin <= end)) return part;
    const auto between = [](double a, double b, double t) { return a + t * (b - a); };
    part.from = line.from + begin * delta;
    part.to = line.from + end * delta;
    part.inv_z_from = between(line.inv_z_from, line.inv_z_to, begin);
    part.inv_z_to = between(line.inv_z_from, line.inv_z_to, end);
    part.is_seen = true;
    return part;
}

void draw_line(const OutsideEye& eye, const glm::dvec3& from, const glm::dvec3& to,
               std::uint32_t colour, int width, SampleGrid& grid) {
    const EyeLine line =
        clipped_to(eye_line(eye, from, to), glm::dvec2(-width), glm::dvec2(grid.size + width));
    if (!line.is_seen) return;
    const glm::dvec2 delta = line.to - line.from;
    const bool is_flat = std::abs(delta.x) >= std::abs(delta.y);
    const int steps = static_cast<int>(std::ceil(is_flat ? std::abs(delta.x) : std::abs(delta.y)));
    const double half = 0.5 * (width - 1);
    for (int i = 0; i <= steps; ++i) {
        const double t = steps > 0 ? static_cast<double>(i) / steps : 0.0;
        const glm::dvec2 at = line.from + t * delta;
        const double inv_z = line.inv_z_from + t * (line.inv_z_to - line.inv_z_from);
        const auto nearness = static_cast<float>(line_bias * inv_z);
        for (int k = 0; k < width; ++k) {
            const double aside = k - half;
            const int column = static_cast<int>(std::floor(at.x + (is_flat ? 0.0 : aside)));
            const int row = static_cast<int>(std::floor(at.y + (is_flat ? aside : 0.0)));
            if (column < 0 || row < 0 || column >= grid.size.x || row >= grid.size.y) continue;
            const std::size_t sample = grid.at(column, row);
            if (nearness >= grid.inv_z[sample]) grid.colour[sample] = colour;
        }
    }
}

} // namespace rasterwalk
