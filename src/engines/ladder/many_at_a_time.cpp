// Many pixels at a time: the loop over a row has no branches, so that the compiler makes it work on
// as many pixels as a register holds: eight with AVX2, four without. Every pixel of the row is lit,
// also where it is hidden; it then keeps what it had.

#include "engines/ladder/many_rows.h"
#include "engines/ladder/rungs.h"

#include <algorithm>

// The same loop is compiled twice, and which one runs is decided while the program runs.
#if defined(__x86_64__)
#define RASTERWALK_INLINED inline __attribute__((always_inline))
#define RASTERWALK_AVX2 __attribute__((target("avx2")))
#else
#define RASTERWALK_INLINED inline
#endif

namespace rasterwalk::rungs {

namespace {

enum class Kind { flat, bent, lit_at_vertices };

/// A row of a triangle: what the loop needs, in single numbers. x counts from `left`.
struct Row {
    int begin = 0, end = -1; ///< covered, both included
    float zinv = 0.0f, step_zinv = 0.0f;
    float ray_x = 0.0f, step_ray_x = 0.0f, ray_y = 0.0f;
    glm::vec3 carried{0.0f}, step_carried{0.0f};
    glm::vec3 normal{0.0f}, lamp{0.0f};
    glm::vec3 power{0.0f}, indirect{0.0f}; ///< times reflectance
};

/// @param depth, colour at the first column of the box
template <Kind kind>
RASTERWALK_INLINED void draw_row(const Row& given, float* depth, std::uint32_t* colour) {
    const Row row = given;
    for (int x = row.begin; x <= row.end; ++x) {
        const auto steps = static_cast<float>(x);
        const float zinv = row.zinv + steps * row.step_zinv;
        glm::vec3 shown = row.carried + steps * row.step_carried;
        if constexpr (kind == Kind::lit_at_vertices) {
            shown = shown * (1.0f / zinv);
        } else {
            const glm::vec3 ray(row.ray_x + steps * row.step_ray_x, row.ray_y, 1.0f);
            const glm::vec3 to_light = row.lamp * zinv - ray;
            const glm::vec3 normal = kind == Kind::bent ? shown : row.normal;
            const float square = kind == Kind::bent ? glm::dot(normal, normal) : 1.0f;
            const float distance2 = glm::dot(to_light, to_light);
            const float share = glm::dot(to_light, normal) /
                                (4.0f * pi * distance2 * std::sqrt(distance2 * square));
            shown = row.power * (std::max(0.0f, share) * zinv * zinv) + row.indirect;
        }
        const std::uint32_t bytes = to_bytes(shown);
        const bool is_nearer = zinv > depth[x];
        depth[x] = is_nearer ? zinv : depth[x];
        colour[x] = is_nearer ? bytes : colour[x];
    }
}

RASTERWALK_INLINED void draw_row_of(Kind kind, const Row& row, float* depth,
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

using DrawRow = void (*)(Kind, const Row&, float* depth, std::uint32_t* colour);

void draw_four(Kind kind, const Row& row, float* depth, std::uint32_t* colour) {
    draw_row_of(kind, row, depth, colour);
}
#if defined(__x86_64__)
RASTERWALK_AVX2 void draw_eight(Kind kind, const Row& row, float* depth, std::uint32_t* colour) {
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
    const Kind kind = lab.is_light_per_vertex    ? Kind::lit_at_vertices
                      : triangle.surface.is_bent ? Kind::bent
                                                 : Kind::flat;
    const auto left = static_cast<float>(triangle.left);
    Row row;
    row.step_zinv = static_cast<float>(triangle.zinv.right);
    row.step_carried = glm::vec3(triangle.carried.right);
    row.ray_x = light.ray_start.x + light.ray_step * left;
    row.step_ray_x = light.ray_step;
    row.normal = triangle.surface.normal;
    row.lamp = light.lamp;
    row.power = triangle.surface.reflectance * lab.light.power;
    row.indirect = triangle.surface.reflectance * lab.light.indirect;
    for (int y = std::max(triangle.top, first_row); y <= std::min(triangle.bottom, end_row - 1);
         ++y) {
        const Span span = span_of(y, triangle);
        if (span.begin > span.end) continue;
        row.begin = span.begin - triangle.left;
        row.end = span.end - triangle.left;
        const auto first = [&](const auto& plane) {
            return plane.start + plane.right * double(triangle.left) + plane.down * double(y);
        };
        row.zinv = static_cast<float>(first(triangle.zinv));
        row.carried = glm::vec3(first(triangle.carried));
        row.ray_y = light.ray_start.y + light.ray_step * static_cast<float>(y);
        const std::size_t place = place_of(triangle.left, y, lab.picture.size);
        draw(kind, row, lab.picture.depth.data() + place, lab.picture.colour.data() + place);
    }
}

} // namespace rasterwalk::rungs

namespace rasterwalk::rungs::many_at_a_time {

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    const PixelLight light = pixel_light(lab);
    for (int t = 0; t < scene.triangle_count(); ++t) {
        if (const auto triangle = screen_triangle(scene, t, lab))
            draw_rows(*triangle, 0, picture.size.height, light, lab);
    }
}

} // namespace rasterwalk::rungs::many_at_a_time
