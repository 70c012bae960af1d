#include "outside/seen_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace rasterwalk {

Rectangle box_around(const OutsideEye& eye, std::span<const glm::dvec3> corners,
                     const Rectangle& area) {
    const auto is_near = [&](const glm::dvec3& corner) { return corner.z < eye.near_distance; };
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& corner : corners) {
        if (!std::isfinite(corner.x + corner.y + corner.z)) return {};
        if (is_near(corner)) continue;
        const glm::dvec2 pixel = eye.pixel(corner);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    if (std::all_of(corners.begin(), corners.end(), is_near)) return {};
    if (std::any_of(corners.begin(), corners.end(), is_near)) return area;
    // A point between two corners may be rounded beyond them.
    const glm::dvec2 first = glm::floor(low) - 1.0, end = glm::ceil(high) + 1.0;
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp<double>(x, area.left, area.right));
    };
    const auto row = [&](double y) {
        return static_cast<int>(std::clamp<double>(y, area.top, area.bottom));
    };
    const Rectangle box{column(first.x), row(first.y), column(end.x), row(end.y)};
    return is_empty(box) ? Rectangle{} : box;
}

} // namespace rasterwalk
