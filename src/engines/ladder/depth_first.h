#pragma once

// What rung depth_first needs for a pixel that passes the depth test: its values are worked out
// from the left end of the row, and only those that its light needs.

#include "engines/ladder/no_vectors.h"

namespace rasterwalk::rungs {

/// A row of the triangle, and how much its values grow from pixel to pixel.
struct RowSteps {
    const Pixel& left;
    float step_zinv;
    glm::vec3 step_position, step_normal, step_illumination;
};

inline RowSteps row_between(const Pixel& left, const Pixel& right) {
    const float steps = std::max(static_cast<float>(right.x - left.x), 1.0f);
    return {left, (right.zinv - left.zinv) / steps, (right.position - left.position) / steps,
            (right.normal - left.normal) / steps, (right.illumination - left.illumination) / steps};
}

/// @param i of the pixel in its row, from 0
inline glm::vec3 pixel_colour(int i, float zinv, const RowSteps& row, const Surface& surface,
                              const Lab& lab) {
    const float steps = static_cast<float>(i);
    if (lab.is_light_per_vertex)
        return (row.left.illumination + steps * row.step_illumination) / zinv;
    const glm::vec3 position = (row.left.position + steps * row.step_position) / zinv;
    const glm::vec3 normal = surface.is_bent
                                 ? glm::normalize(row.left.normal + steps * row.step_normal)
                                 : surface.normal;
    return surface.reflectance * light_at(position, normal, lab.light);
}

} // namespace rasterwalk::rungs
