#pragma once

// The rows of rung depth_first: along them only 1/z is stepped. All other values are worked out
// from the left end of the row for the pixels that pass the test, and only those that their light
// needs.

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

/// Draws the rows of a triangle.
/// @param colour_of gives the colour of a pixel that has passed, from the arguments of
/// pixel_colour()
template <class ColourOf>
void draw_rows_depth_first(int rows, const RowTable& table, const Surface& surface, const Lab& lab,
                           ColourOf colour_of) {
    const Viewport size = lab.picture.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); ++i) {
        const Pixel& left = table.left_pixels[i];
        const Pixel& right = table.right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        if (left.y < 0 || left.y >= size.height) continue;
        const RowSteps row = row_between(left, right);
        float zinv = left.zinv;
        for (int x = left.x; x <= right.x; ++x, zinv += row.step_zinv) {
            if (x < 0 || x >= size.width) continue;
            const std::size_t place = place_of(x, left.y, size);
            if (zinv <= lab.picture.depth[place]) continue;
            lab.picture.depth[place] = zinv;
            lab.picture.colour[place] = to_bytes(colour_of(x - left.x, zinv, row, surface, lab));
        }
    }
}

} // namespace rasterwalk::rungs
