// The lab's loop as a student writes it: a std::vector for every polygon, edge and row, and one
// pixel at a time. It is the first rung of the ladder and the baseline for the engines, and it is
// written to be read, not to be fast.
//
// Picture: interpolate() walks the edges of each polygon; they fill the row table, left_pixels and
//          right_pixels; each row is then walked in the same way, and its pixels are shaded.
//
// It is slow because memory is allocated at every edge and row, a pixel carries all of its values
// through every step, and light, roots and divisions are worked out one pixel at a time.
//
// Its edges are those of the lab: vertices and samples are rounded to whole pixels.

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

#include "engines/ladder/lab_loop.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::lab_loop {

namespace {

void compute_polygon_rows(const std::vector<Pixel>& vertex_pixels, std::vector<Pixel>& left_pixels,
                          std::vector<Pixel>& right_pixels) {
    int top = std::numeric_limits<int>::max(), bottom = std::numeric_limits<int>::min();
    for (const Pixel& vertex : vertex_pixels) {
        top = std::min(top, vertex.y);
        bottom = std::max(bottom, vertex.y);
    }
    const int rows = bottom - top + 1;
    left_pixels.resize(static_cast<std::size_t>(rows));
    right_pixels.resize(static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        left_pixels[static_cast<std::size_t>(row)].x = std::numeric_limits<int>::max();
        right_pixels[static_cast<std::size_t>(row)].x = -std::numeric_limits<int>::max();
    }
    for (std::size_t i = 0; i < vertex_pixels.size(); ++i) {
        const Pixel& a = vertex_pixels[i];
        const Pixel& b = vertex_pixels[(i + 1) % vertex_pixels.size()];
        const int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        std::vector<Pixel> line(static_cast<std::size_t>(count));
        interpolate(a, b, line);
        for (const Pixel& pixel : line) {
            // The errors of many additions can end in the row above the first.
            if (pixel.y < top || pixel.y > bottom) continue;
            const auto row = static_cast<std::size_t>(pixel.y - top);
            if (pixel.x < left_pixels[row].x) left_pixels[row] = pixel;
            if (pixel.x > right_pixels[row].x) right_pixels[row] = pixel;
        }
    }
}

void draw_polygon_rows(const std::vector<Pixel>& left_pixels,
                       const std::vector<Pixel>& right_pixels, const Surface& surface,
                       const Lab& lab) {
    for (std::size_t i = 0; i < left_pixels.size(); ++i) {
        const Pixel& left = left_pixels[i];
        const Pixel& right = right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        std::vector<Pixel> row(static_cast<std::size_t>(right.x - left.x + 1));
        interpolate(left, right, row);
        for (const Pixel& pixel : row)
            pixel_shader(pixel, surface, lab);
    }
}

void draw_polygon(const std::vector<Vertex>& vertices, const Surface& surface, const Lab& lab) {
    std::vector<Pixel> vertex_pixels(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertex_pixels[i] = vertex_shader(vertices[i], lab);
    std::vector<Pixel> left_pixels, right_pixels;
    compute_polygon_rows(vertex_pixels, left_pixels, right_pixels);
    draw_polygon_rows(left_pixels, right_pixels, surface, lab);
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const auto corners = corners_of(scene, t);
        const std::vector<Vertex> vertices(corners.begin(), corners.end());
        draw_polygon(vertices, surface_of(corners), lab);
    }
}

} // namespace rasterwalk::rungs::lab_loop
