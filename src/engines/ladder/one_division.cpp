// The lab's loop with one division and one root for the light of a pixel.
//
// With everything divided by z, r / z = lamp / z - position / z needs no division, and
//
//     power (n . r) / (4 pi r^3)  =  power (n . r/z) (1/z)^2 / (4 pi (r/z)^3)

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>
#include <vector>

#include "engines/ladder/parts.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::one_division {

namespace {

struct Pixel {
    int x = 0, y = 0;
    float zinv = 0.0f;
    // Divided by z, so that they change in equal steps across the screen.
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
    glm::vec3 illumination{0.0f}; ///< worked out at the vertices; else unused
};

/// The row table. Its memory stays.
struct RowTable {
    std::vector<Pixel> left_pixels, right_pixels;
};

/// The first pixels of a vector, which grows if it has not so many.
std::span<Pixel> first(int count, std::vector<Pixel>& kept) {
    const auto size = static_cast<std::size_t>(count);
    if (kept.size() < size) kept.resize(size);
    return {kept.data(), size};
}

Pixel vertex_shader(const Vertex& vertex, const Lab& lab) {
    const glm::vec3 seen = vertex.position - lab.eye;
    Pixel pixel;
    pixel.zinv = 1.0f / seen.z;
    pixel.x = static_cast<int>(lab.focal_length * seen.x * pixel.zinv) + lab.picture.size.width / 2;
    pixel.y =
        static_cast<int>(lab.focal_length * seen.y * pixel.zinv) + lab.picture.size.height / 2;
    pixel.position = vertex.position * pixel.zinv;
    pixel.normal = vertex.normal * pixel.zinv;
    if (lab.is_light_per_vertex)
        pixel.illumination =
            vertex.reflectance * light_at(vertex.position, vertex.normal, lab.light) * pixel.zinv;
    return pixel;
}

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
int compute_polygon_rows(std::span<const Pixel> vertex_pixels, RowTable& table) {
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

/// A row of the triangle, and how much its values grow from pixel to pixel.
struct Row {
    const Pixel& left;
    float step_zinv;
    glm::vec3 step_position, step_normal, step_illumination;
};

Row row_between(const Pixel& left, const Pixel& right) {
    const float steps = std::max(static_cast<float>(right.x - left.x), 1.0f);
    return {left, (right.zinv - left.zinv) / steps, (right.position - left.position) / steps,
            (right.normal - left.normal) / steps, (right.illumination - left.illumination) / steps};
}

/// @param i of the pixel in its row, from 0
glm::vec3 pixel_colour(int i, float zinv, const Row& row, const Surface& surface, const Lab& lab) {
    const float steps = static_cast<float>(i);
    if (lab.is_light_per_vertex)
        return (row.left.illumination + steps * row.step_illumination) * (1.0f / zinv);
    const glm::vec3 to_light =
        lab.light.position * zinv - (row.left.position + steps * row.step_position);
    float distance2 = glm::dot(to_light, to_light), share = 0.0f;
    if (surface.is_bent) {
        const glm::vec3 normal = row.left.normal + steps * row.step_normal;
        share = glm::dot(to_light, normal) /
                (4.0f * pi * distance2 * std::sqrt(distance2 * glm::dot(normal, normal)));
    } else {
        share = glm::dot(to_light, surface.normal) / (4.0f * pi * distance2 * std::sqrt(distance2));
    }
    share = std::max(0.0f, share) * zinv * zinv;
    return surface.reflectance * (lab.light.power * share + lab.light.indirect);
}

void draw_polygon_rows(int rows, const RowTable& table, const Surface& surface, const Lab& lab) {
    const Viewport size = lab.picture.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows); ++i) {
        const Pixel& left = table.left_pixels[i];
        const Pixel& right = table.right_pixels[i];
        if (left.x > right.x) continue; // no sample has reached the row
        if (left.y < 0 || left.y >= size.height) continue;
        const Row row = row_between(left, right);
        float zinv = left.zinv;
        for (int x = left.x; x <= right.x; ++x, zinv += row.step_zinv) {
            if (x < 0 || x >= size.width) continue;
            const std::size_t place = place_of(x, left.y, size);
            if (zinv <= lab.picture.depth[place]) continue;
            lab.picture.depth[place] = zinv;
            lab.picture.colour[place] = to_bytes(pixel_colour(x - left.x, zinv, row, surface, lab));
        }
    }
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    RowTable table;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        const auto corners = corners_of(scene, t);
        std::array<Pixel, triangle_corners> vertex_pixels;
        for (std::size_t i = 0; i < corners.size(); ++i)
            vertex_pixels[i] = vertex_shader(corners[i], lab);
        const int rows = compute_polygon_rows(vertex_pixels, table);
        draw_polygon_rows(rows, table, surface_of(corners), lab);
    }
}

} // namespace rasterwalk::rungs::one_division
