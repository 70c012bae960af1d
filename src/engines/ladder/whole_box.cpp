// A wrong turning: the same as edge_functions.cpp, but every pixel of the triangle's box is tested
// against all three edges. The picture is the same. That suits hardware, which tests many pixels at
// once; here about half of the tests are for nothing.

#include <algorithm>

#include "engines/ladder/rungs.h"
#include "engines/ladder/runs.h"

namespace rasterwalk::rungs::whole_box {

namespace {

/// The edge functions at a pixel, and how much they grow to the next one.
struct Inside {
    std::array<std::int64_t, triangle_corners> value{}, step{};
};

/// @param count  pixels of the box in this row
/// @param inside at the first of them
/// @param depth, colour at the same place
template <Kind kind>
void draw_row(const Run& given, int count, const Inside& inside, float* depth,
              std::uint32_t* colour) {
    const Run row = given;
    auto [inside0, inside1, inside2] = inside.value;
    for (int x = 0; x < count; ++x) {
        const bool is_covered = inside0 > 0 && inside1 > 0 && inside2 > 0;
        inside0 += inside.step[0];
        inside1 += inside.step[1];
        inside2 += inside.step[2];
        if (!is_covered) continue;
        const auto steps = static_cast<float>(x);
        const float zinv = row.zinv + steps * row.step_zinv;
        if (zinv <= depth[x]) continue;
        const glm::vec3 ray(row.ray_x + steps * row.step_ray, row.ray_y, 1.0f);
        depth[x] = zinv;
        colour[x] = to_bytes(colour_in<kind>(row, steps, zinv, ray));
    }
}

using DrawRow = void (*)(const Run&, int count, const Inside&, float* depth, std::uint32_t* colour);

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
    Inside inside;
    for (std::size_t i = 0; i < triangle.edges.size(); ++i)
        inside.step[i] = triangle.edges[i].right;
    for (int y = triangle.top; y <= triangle.bottom; ++y) {
        for (std::size_t i = 0; i < triangle.edges.size(); ++i) {
            const Edge& edge = triangle.edges[i];
            inside.value[i] = edge.start + edge.right * triangle.left + edge.down * y;
        }
        begin_at(triangle.left, y, triangle, light, row);
        const std::size_t place = place_of(triangle.left, y, lab.picture.size);
        draw_row(row, triangle.right - triangle.left + 1, inside, lab.picture.depth.data() + place,
                 lab.picture.colour.data() + place);
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    for_each_screen_triangle(
        scene, lab, [&](const ScreenTriangle& triangle) { draw_triangle(triangle, light, lab); });
}

} // namespace rasterwalk::rungs::whole_box
