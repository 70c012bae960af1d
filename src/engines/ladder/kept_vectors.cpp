// The lab's loop with vectors that stay: those of the corners, of the row table, of an edge and of
// a row are allocated once, and grow only until they are long enough. Nothing else has changed.

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

#include "engines/ladder/kept_vectors.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::kept_vectors {

namespace {

/// The memory of a picture.
struct Kept {
    std::vector<Pixel> left_pixels, right_pixels, line, row;
};

/// @return how many rows the table has
int compute_polygon_rows(std::span<const Pixel> vertex_pixels, Kept& kept) {
    int top = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::min();
    for (const Pixel& vertex : vertex_pixels) {
        top = std::min(top, vertex.y);
        bottom = std::max(bottom, vertex.y);
    }
    const int rows = bottom - top + 1;
    const std::span<Pixel> left_pixels = first(rows, kept.left_pixels);
    const std::span<Pixel> right_pixels = first(rows, kept.right_pixels);
    for (int row = 0; row < rows; ++row) {
        left_pixels[static_cast<std::size_t>(row)].x = std::numeric_limits<int>::max();
        right_pixels[static_cast<std::size_t>(row)].x = -std::numeric_limits<int>::max();
    }
    for (std::size_t i = 0; i < vertex_pixels.size(); ++i) {
        const Pixel& a = vertex_pixels[i];
        const Pixel& b = vertex_pixels[(i + 1) % vertex_pixels.size()];
        const int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        const std::span<Pixel> line = first(count, kept.line);
        interpolate(a, b, line);
        for (const Pixel& pixel : line) {
            // The errors of many additions can end in the row above the first.
            if (pixel.y < top || pixel.y > bottom) continue;
            const auto row = static_cast<std::size_t>(pixel.y - top);
            if (pixel.x < left_pixels[row].x) left_pixels[row] = pixel;
            if (pixel.x > right_pixels[row].x) right_pixels[row] = pixel;
        }
    }
    return rows;
}

void draw_polygon_rows(int rows, Kept& kept, const Surface& surface, const Lab& lab) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); ++i) {
        const Pixel& left = kept.left_pixels[i];
        const Pixel& right = kept.right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        const std::span<Pixel> row = first(right.x - left.x + 1, kept.row);
        interpolate(left, right, row);
        for (const Pixel& pixel : row)
            pixel_shader(pixel, surface, lab);
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    Kept kept;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const auto corners = corners_of(scene, t);
        std::array<Pixel, triangle_corners> vertex_pixels;
        for (std::size_t i = 0; i < corners.size(); ++i)
            vertex_pixels[i] = vertex_shader(corners[i], lab);
        const int rows = compute_polygon_rows(vertex_pixels, kept);
        draw_polygon_rows(rows, kept, surface_of(corners), lab);
    }
}

} // namespace rasterwalk::rungs::kept_vectors
