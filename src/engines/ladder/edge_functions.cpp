// Edge functions, solved for the column: in each row, three divisions say where the triangle begins
// and ends. There is no row table, and nothing is carried along edges: 1/z grows in equal steps
// across the screen, and where a pixel is in the world follows from its column, row and 1/z.
//
// Source: Pineda 1988, "A Parallel Algorithm for Polygon Rasterization".
//
// This changes which pixels a triangle covers: corners are no longer rounded to whole pixels, what
// counts is the centre of a pixel, and one that is exactly on an edge belongs to only one of the
// triangles there. Its light is that of its centre, too.

#include <algorithm>

#include "engines/ladder/rungs.h"
#include "engines/ladder/runs.h"

namespace rasterwalk::rungs::edge_functions {

namespace {

/// @param depth, colour at the first column of the box
template <Kind kind>
void draw_row(const Run& given, float* depth, std::uint32_t* colour) {
    const Run row = given;
    for (int x = row.begin; x <= row.end; ++x) {
        const auto steps = static_cast<float>(x);
        const float zinv = row.zinv + steps * row.step_zinv;
        if (zinv <= depth[x]) continue;
        const glm::vec3 ray(row.ray_x + steps * row.step_ray, row.ray_y, 1.0f);
        depth[x] = zinv;
        colour[x] = to_bytes(colour_in<kind>(row, steps, zinv, ray));
    }
}

using DrawRow = void (*)(const Run&, float* depth, std::uint32_t* colour);

DrawRow draw_row_of(Kind kind) {
    switch (kind) {
    case Kind::flat:
        return draw_row<Kind::flat>;
    case Kind::bent:
        return draw_row<Kind::bent>;
    case Kind::lit_at_vertices:
        break;
    }
    return draw_row<Kind::lit_at_vertices>;
}

void draw_triangle(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab) {
    const DrawRow draw_row = draw_row_of(kind_of(triangle.surface, lab));
    Run row = row_in(triangle, light, lab);
    for (int y = triangle.top; y <= triangle.bottom; ++y) {
        const Span span = span_of(y, triangle);
        if (span.begin > span.end) continue;
        row.begin = span.begin - triangle.left;
        row.end = span.end - triangle.left;
        begin_at(triangle.left, y, triangle, light, row);
        const std::size_t place = place_of(triangle.left, y, lab.picture.size);
        draw_row(row, lab.picture.depth.data() + place, lab.picture.colour.data() + place);
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    for_each_screen_triangle(
        scene, lab, [&](const ScreenTriangle& triangle) { draw_triangle(triangle, light, lab); });
}

} // namespace rasterwalk::rungs::edge_functions
