// A wrong turning: the same as many_at_a_time.cpp, but with the loop over columns outside and the
// loop over rows inside. The picture is the same. Two pixels that follow each other are now a whole
// row apart in memory: each is in another line of the cache, and no instruction reads several.

#include <algorithm>

#include "engines/ladder/rungs.h"
#include "engines/ladder/screen_triangle.h"

// The same loop is compiled twice, and which one runs is decided while the program runs.
#if defined(__x86_64__)
#define RASTERWALK_INLINED inline __attribute__((always_inline))
#define RASTERWALK_AVX2 __attribute__((target("avx2")))
#else
#define RASTERWALK_INLINED inline
#endif

namespace rasterwalk::rungs::columns_first {

namespace {

enum class Kind { flat, bent, lit_at_vertices };

/// A column of a triangle: what the loop needs, in single numbers. y counts from `top`.
struct Column {
    int begin = 0, end = -1; ///< covered, both included
    std::size_t stride = 0;  ///< from row to row
    float zinv = 0.0f, step_zinv = 0.0f;
    float ray_y = 0.0f, step_ray_y = 0.0f, ray_x = 0.0f;
    glm::vec3 carried{0.0f}, step_carried{0.0f};
    glm::vec3 normal{0.0f}, lamp{0.0f};
    glm::vec3 power{0.0f}, indirect{0.0f}; ///< times reflectance
};

/// @param depth, colour at the first row of the box
template <Kind kind>
RASTERWALK_INLINED void draw_column(const Column& given, float* depth, std::uint32_t* colour) {
    const Column column = given;
    for (int y = column.begin; y <= column.end; ++y) {
        const std::size_t place = static_cast<std::size_t>(y) * column.stride;
        const auto steps = static_cast<float>(y);
        const float zinv = column.zinv + steps * column.step_zinv;
        glm::vec3 shown = column.carried + steps * column.step_carried;
        if constexpr (kind == Kind::lit_at_vertices) {
            shown = shown * (1.0f / zinv);
        } else {
            const glm::vec3 ray(column.ray_x, column.ray_y + steps * column.step_ray_y, 1.0f);
            const glm::vec3 to_light = column.lamp * zinv - ray;
            const glm::vec3 normal = kind == Kind::bent ? shown : column.normal;
            const float square = kind == Kind::bent ? glm::dot(normal, normal) : 1.0f;
            const float distance2 = glm::dot(to_light, to_light);
            const float share = glm::dot(to_light, normal) /
                                (4.0f * pi * distance2 * std::sqrt(distance2 * square));
            shown = column.power * (std::max(0.0f, share) * zinv * zinv) + column.indirect;
        }
        const std::uint32_t bytes = to_bytes(shown);
        const bool is_nearer = zinv > depth[place];
        depth[place] = is_nearer ? zinv : depth[place];
        colour[place] = is_nearer ? bytes : colour[place];
    }
}

RASTERWALK_INLINED void draw_column_of(Kind kind, const Column& column, float* depth,
                                       std::uint32_t* colour) {
    switch (kind) {
    case Kind::flat:
        return draw_column<Kind::flat>(column, depth, colour);
    case Kind::bent:
        return draw_column<Kind::bent>(column, depth, colour);
    case Kind::lit_at_vertices:
        return draw_column<Kind::lit_at_vertices>(column, depth, colour);
    }
}

using DrawColumn = void (*)(Kind, const Column&, float* depth, std::uint32_t* colour);

void draw_four(Kind kind, const Column& column, float* depth, std::uint32_t* colour) {
    draw_column_of(kind, column, depth, colour);
}
#if defined(__x86_64__)
RASTERWALK_AVX2 void draw_eight(Kind kind, const Column& column, float* depth,
                                std::uint32_t* colour) {
    draw_column_of(kind, column, depth, colour);
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
    const Kind kind = lab.is_light_per_vertex    ? Kind::lit_at_vertices
                      : triangle.surface.is_bent ? Kind::bent
                                                 : Kind::flat;
    const auto top = static_cast<float>(triangle.top);
    Column column;
    column.stride = static_cast<std::size_t>(lab.picture.size.width);
    column.step_zinv = static_cast<float>(triangle.zinv.down);
    column.step_carried = glm::vec3(triangle.carried.down);
    column.ray_y = light.ray_start.y + light.ray_step * top;
    column.step_ray_y = light.ray_step;
    column.normal = triangle.surface.normal;
    column.lamp = light.lamp;
    column.power = triangle.surface.reflectance * lab.light.power;
    column.indirect = triangle.surface.reflectance * lab.light.indirect;
    for (int x = triangle.left; x <= triangle.right; ++x) {
        const Span span = column_span_of(x, triangle);
        if (span.begin > span.end) continue;
        column.begin = span.begin - triangle.top;
        column.end = span.end - triangle.top;
        const auto first = [&](const auto& plane) {
            return plane.start + plane.right * double(x) + plane.down * double(triangle.top);
        };
        column.zinv = static_cast<float>(first(triangle.zinv));
        column.carried = glm::vec3(first(triangle.carried));
        column.ray_x = light.ray_start.x + light.ray_step * static_cast<float>(x);
        const std::size_t place = place_of(x, triangle.top, lab.picture.size);
        draw(kind, column, lab.picture.depth.data() + place, lab.picture.colour.data() + place);
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    for (int t = 0; t < scene.triangle_count(); ++t) {
        if (const auto triangle = screen_triangle(scene, t, lab))
            draw_triangle(*triangle, light, lab);
    }
}

} // namespace rasterwalk::rungs::columns_first
