#pragma once

// How rung no_vectors walks edges and rows, and the rungs after it walk edges: interpolate() hands
// each pixel on as soon as it has made it, and keeps none. Only the ends of the rows are kept.

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

#include "engines/ladder/kept_vectors.h"

namespace rasterwalk::rungs {

/// The row table. Its memory stays.
struct RowTable {
    std::vector<Pixel> left_pixels, right_pixels;
};

/// Calls use(pixel) for `count` pixels from a to b.
template <class Use>
void interpolate(const Pixel& a, const Pixel& b, int count, Use use) {
    const float steps = std::max(static_cast<float>(count) - 1.0f, 1.0f);
    const float step_x = static_cast<float>(b.x - a.x) / steps;
    const float step_y = static_cast<float>(b.y - a.y) / steps;
    const float step_zinv = (b.zinv - a.zinv) / steps;
    const glm::vec3 step_position = (b.position - a.position) / steps;
    const glm::vec3 step_normal = (b.normal - a.normal) / steps;
    const glm::vec3 step_illumination = (b.illumination - a.illumination) / steps;
    float x = static_cast<float>(a.x), y = static_cast<float>(a.y);
    Pixel current = a;
    for (int i = 0; i < count; ++i) {
        current.x = static_cast<int>(x);
        current.y = static_cast<int>(y);
        use(current);
        x += step_x;
        y += step_y;
        current.zinv += step_zinv;
        current.position += step_position;
        current.normal += step_normal;
        current.illumination += step_illumination;
    }
}

/// @return how many rows the table has
inline int compute_polygon_rows(std::span<const Pixel> vertex_pixels, RowTable& table) {
    int top = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::min();
    for (const Pixel& vertex : vertex_pixels) {
        top = std::min(top, vertex.y);
        bottom = std::max(bottom, vertex.y);
    }
    const int rows = bottom - top + 1;
    const std::span<Pixel> left_pixels = first(rows, table.left_pixels);
    const std::span<Pixel> right_pixels = first(rows, table.right_pixels);
    for (int row = 0; row < rows; ++row) {
        left_pixels[static_cast<std::size_t>(row)].x = std::numeric_limits<int>::max();
        right_pixels[static_cast<std::size_t>(row)].x = -std::numeric_limits<int>::max();
    }
    for (std::size_t i = 0; i < vertex_pixels.size(); ++i) {
        const Pixel& a = vertex_pixels[i];
        const Pixel& b = vertex_pixels[(i + 1) % vertex_pixels.size()];
        const int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        interpolate(a, b, count, [&](const Pixel& pixel) {
            // The errors of many additions can end in the row above the first.
            if (pixel.y < top || pixel.y > bottom) return;
            const auto row = static_cast<std::size_t>(pixel.y - top);
            if (pixel.x < left_pixels[row].x) left_pixels[row] = pixel;
            if (pixel.x > right_pixels[row].x) right_pixels[row] = pixel;
        });
    }
    return rows;
}

/// Calls use(rows, table, surface) for each triangle: `rows` rows of its table count.
template <class Use>
void for_each_row_table(const Scene& scene, const Lab& lab, Use use) {
    RowTable table;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const auto corners = corners_of(scene, t);
        std::array<Pixel, triangle_corners> vertex_pixels;
        for (std::size_t i = 0; i < corners.size(); ++i)
            vertex_pixels[i] = vertex_shader(corners[i], lab);
        const int rows = compute_polygon_rows(vertex_pixels, table);
        use(rows, table, surface_of(corners));
    }
}

} // namespace rasterwalk::rungs
