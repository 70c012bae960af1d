// Many pixels at a time: the loop over a row has no branches, so that the compiler makes it work on
// as many pixels as a register holds: eight with AVX2, four without. Every pixel of the row is lit,
// also where it is hidden; it then keeps what it had.

#include <algorithm>

#include "engines/ladder/many_rows.h"
#include "engines/ladder/rungs.h"
#include "engines/ladder/runs.h"

namespace rasterwalk::rungs {

namespace {

/// @param depth, colour at the first column of the box
template <Kind kind>
RASTERWALK_INLINED void draw_row(const Run& given, float* depth, std::uint32_t* colour) {
    const Run row = given;
    for (int x = row.begin; x <= row.end; ++x) {
        const auto steps = static_cast<float>(x);
        const float zinv = row.zinv + steps * row.step_zinv;
        const glm::vec3 ray(row.ray_x + steps * row.step_ray, row.ray_y, 1.0f);
        const std::uint32_t bytes = to_bytes(colour_in<kind>(row, steps, zinv, ray));
        const bool is_nearer = zinv > depth[x];
        depth[x] = is_nearer ? zinv : depth[x];
        colour[x] = is_nearer ? bytes : colour[x];
    }
}

// The same loop is compiled twice, and which one runs is decided while the program runs.

RASTERWALK_INLINED void draw_row_of(Kind kind, const Run& row, float* depth,
                                    std::uint32_t* colour) {
    switch (kind) {
    case Kind::flat:
        return draw_row<Kind::flat>(row, depth, colour);
    case Kind::bent:
        return draw_row<Kind::bent>(row, depth, colour);
    case Kind::lit_at_vertices:
        return draw_row<Kind::lit_at_vertices>(row, depth, colour);
    }
}

using DrawRow = void (*)(Kind, const Run&, float* depth, std::uint32_t* colour);

void draw_four(Kind kind, const Run& row, float* depth, std::uint32_t* colour) {
    draw_row_of(kind, row, depth, colour);
}
#if defined(__x86_64__)
RASTERWALK_AVX2 void draw_eight(Kind kind, const Run& row, float* depth, std::uint32_t* colour) {
    draw_row_of(kind, row, depth, colour);
}
#endif

DrawRow best_draw_row() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return draw_eight;
#endif
    return draw_four;
}

} // namespace

void draw_rows(const ScreenTriangle& triangle, int first_row, int end_row, const PixelLight& light,
               const Lab& lab) {
    static const DrawRow draw = best_draw_row();
    const Kind kind = kind_of(triangle.surface, lab);
    Run row = row_in(triangle, light, lab);
    for (int y = std::max(triangle.top, first_row); y <= std::min(triangle.bottom, end_row - 1);
         ++y) {
        const Span span = span_of(y, triangle);
        if (span.begin > span.end) continue;
        row.begin = span.begin - triangle.left;
        row.end = span.end - triangle.left;
        begin_at(triangle.left, y, triangle, light, row);
        const std::size_t place = place_of(triangle.left, y, lab.picture.size);
        draw(kind, row, lab.picture.depth.data() + place, lab.picture.colour.data() + place);
    }
}

} // namespace rasterwalk::rungs

namespace rasterwalk::rungs::many_at_a_time {

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    for_each_screen_triangle(scene, lab, [&](const ScreenTriangle& triangle) {
        draw_rows(triangle, 0, picture.size.height, light, lab);
    });
}

} // namespace rasterwalk::rungs::many_at_a_time
