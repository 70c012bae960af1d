// A wrong turning: the same as many_at_a_time.cpp, but with the loop over columns outside and the
// loop over rows inside. The picture is the same. Two pixels that follow each other are now a whole
// row apart in memory: each is in another line of the cache, and no instruction reads several.

#include <algorithm>

#include "engines/ladder/rungs.h"
#include "engines/ladder/runs.h"

namespace rasterwalk::rungs::columns_first {

namespace {

/// @param stride from row to row
/// @param depth, colour at the first row of the box
template <Kind kind>
RASTERWALK_INLINED void draw_column(const Run& given, std::size_t stride, float* depth,
                                    std::uint32_t* colour) {
    const Run column = given;
    for (int y = column.begin; y <= column.end; ++y) {
        const std::size_t place = static_cast<std::size_t>(y) * stride;
        const auto steps = static_cast<float>(y);
        const float zinv = column.zinv + steps * column.step_zinv;
        const glm::vec3 ray(column.ray_x, column.ray_y + steps * column.step_ray, 1.0f);
        const std::uint32_t bytes = to_bytes(colour_in<kind>(column, steps, zinv, ray));
        const bool is_nearer = zinv > depth[place];
        depth[place] = is_nearer ? zinv : depth[place];
        colour[place] = is_nearer ? bytes : colour[place];
    }
}

RASTERWALK_INLINED void draw_column_of(Kind kind, const Run& column, std::size_t stride,
                                       float* depth, std::uint32_t* colour) {
    switch (kind) {
    case Kind::flat:
        return draw_column<Kind::flat>(column, stride, depth, colour);
    case Kind::bent:
        return draw_column<Kind::bent>(column, stride, depth, colour);
    case Kind::lit_at_vertices:
        return draw_column<Kind::lit_at_vertices>(column, stride, depth, colour);
    }
}

using DrawColumn = void (*)(Kind, const Run&, std::size_t stride, float* depth,
                            std::uint32_t* colour);

void draw_four(Kind kind, const Run& column, std::size_t stride, float* depth,
               std::uint32_t* colour) {
    draw_column_of(kind, column, stride, depth, colour);
}
#if defined(__x86_64__)
RASTERWALK_AVX2 void draw_eight(Kind kind, const Run& column, std::size_t stride, float* depth,
                                std::uint32_t* colour) {
    draw_column_of(kind, column, stride, depth, colour);
}
#endif

DrawColumn best_draw_column() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return draw_eight;
#endif
    return draw_four;
}

/// The covered pixels of a column of the box: span_of() with columns and rows exchanged.
Span column_span_of(int x, ScreenTriangle triangle) {
    std::swap(triangle.left, triangle.top);
    std::swap(triangle.right, triangle.bottom);
    for (Edge& edge : triangle.edges)
        std::swap(edge.right, edge.down);
    return span_of(x, triangle);
}

void draw_triangle(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab) {
    static const DrawColumn draw = best_draw_column();
    const Kind kind = kind_of(triangle.surface, lab);
    const auto stride = static_cast<std::size_t>(lab.picture.size.width);
    Run column = run_in(triangle, light, lab);
    column.step_zinv = static_cast<float>(triangle.zinv.down);
    column.step_carried = glm::vec3(triangle.carried.down);
    for (int x = triangle.left; x <= triangle.right; ++x) {
        const Span span = column_span_of(x, triangle);
        if (span.begin > span.end) continue;
        column.begin = span.begin - triangle.top;
        column.end = span.end - triangle.top;
        begin_at(x, triangle.top, triangle, light, column);
        const std::size_t place = place_of(x, triangle.top, lab.picture.size);
        draw(kind, column, stride, lab.picture.depth.data() + place,
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

} // namespace rasterwalk::rungs::columns_first
