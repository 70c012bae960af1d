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
#include "engines/ladder/screen_triangle.h"

namespace rasterwalk::rungs::edge_functions {

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
void draw_row(const Row& given, float* depth, std::uint32_t* colour) {
    const Row row = given;
    for (int x = row.begin; x <= row.end; ++x) {
        const auto steps = static_cast<float>(x);
        const float zinv = row.zinv + steps * row.step_zinv;
        if (zinv <= depth[x]) continue;
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
        depth[x] = zinv;
        colour[x] = to_bytes(shown);
    }
}

using DrawRow = void (*)(const Row&, float* depth, std::uint32_t* colour);

DrawRow draw_row_of(const Surface& surface, const Lab& lab) {
    if (lab.is_light_per_vertex) return draw_row<Kind::lit_at_vertices>;
    return surface.is_bent ? draw_row<Kind::bent> : draw_row<Kind::flat>;
}

void draw_triangle(const ScreenTriangle& triangle, const PixelLight& light, const Lab& lab) {
    const DrawRow draw_row = draw_row_of(triangle.surface, lab);
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
    for (int y = triangle.top; y <= triangle.bottom; ++y) {
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
        draw_row(row, lab.picture.depth.data() + place, lab.picture.colour.data() + place);
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

} // namespace rasterwalk::rungs::edge_functions
