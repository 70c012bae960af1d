#include "engines/ladder/screen_triangle.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk::rungs {

namespace {

constexpr int subpixels = 256;

/// A corner in whole 256ths of a pixel.
struct Corner {
    std::int64_t x = 0, y = 0;
    double zinv = 0.0;
    glm::dvec3 carried{0.0};
};

std::int64_t to_subpixels(float pixels) {
    return static_cast<std::int64_t>(std::floor(pixels * float{subpixels} + 0.5f));
}

/// The middle of the picture, in whole pixels from its corner.
glm::vec2 middle_of(Viewport size) {
    const int column = size.width / 2, row = size.height / 2;
    return {static_cast<float>(column), static_cast<float>(row)};
}

Corner corner_of(const Vertex& vertex, const Surface& surface, const Lab& lab) {
    const glm::vec3 seen = vertex.position - lab.eye;
    const float zinv = 1.0f / seen.z, scale = zinv * lab.focal_length;
    const glm::vec2 middle = middle_of(lab.picture.size);
    Corner corner;
    corner.x = to_subpixels(seen.x * scale + middle.x);
    corner.y = to_subpixels(seen.y * scale + middle.y);
    corner.zinv = zinv;
    if (lab.is_light_per_vertex) {
        corner.carried =
            glm::dvec3(vertex.reflectance * light_at(vertex.position, vertex.normal, lab.light)) *
            corner.zinv;
    } else if (surface.is_bent) {
        corner.carried = glm::dvec3(vertex.normal) * corner.zinv;
    }
    return corner;
}

/// @param a, b in clockwise order on the screen
Edge edge_between(const Corner& a, const Corner& b) {
    constexpr std::int64_t half = subpixels / 2;
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool is_top_or_left = dy < 0 || (dy == 0 && dx > 0);
    return {dx * (half - a.y) - dy * (half - a.x) + (is_top_or_left ? 1 : 0), -dy * subpixels,
            dx * subpixels};
}

/// The plane through the values of the corners.
template <class Value>
Plane<Value> plane_of(const std::array<Corner, 3>& corners, double double_area,
                      Value Corner::*value) {
    const auto& [a, b, c] = corners;
    const auto pixels = [](std::int64_t distance) {
        return static_cast<double>(distance) / subpixels;
    };
    const Value ab = b.*value - a.*value, ac = c.*value - a.*value;
    Plane<Value> plane;
    plane.right = (ab * pixels(c.y - a.y) - ac * pixels(b.y - a.y)) / double_area;
    plane.down = (ac * pixels(b.x - a.x) - ab * pixels(c.x - a.x)) / double_area;
    plane.start = a.*value + (0.5 - pixels(a.x)) * plane.right + (0.5 - pixels(a.y)) * plane.down;
    return plane;
}

/// The first pixel whose centre is at or after a coordinate.
int first_pixel(std::int64_t coordinate) {
    return static_cast<int>((coordinate + (subpixels / 2 - 1)) >> 8);
}

/// a / b, rounded down; b above 0.
std::int64_t floor_of(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

} // namespace

std::optional<ScreenTriangle> screen_triangle(const Scene& scene, int triangle, const Lab& lab) {
    const auto vertices = corners_of(scene, triangle);
    ScreenTriangle result;
    result.surface = surface_of(vertices);
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = corner_of(vertices[i], result.surface, lab);
    auto& [a, b, c] = corners;
    std::int64_t area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (area == 0) return std::nullopt;
    if (area < 0) {
        std::swap(b, c);
        area = -area;
    }
    const Viewport size = lab.picture.size;
    result.left = std::max(first_pixel(std::min({a.x, b.x, c.x})), 0);
    result.right = std::min(first_pixel(std::max({a.x, b.x, c.x})), size.width) - 1;
    result.top = std::max(first_pixel(std::min({a.y, b.y, c.y})), 0);
    result.bottom = std::min(first_pixel(std::max({a.y, b.y, c.y})), size.height) - 1;
    if (result.left > result.right || result.top > result.bottom) return std::nullopt;
    result.edges = {edge_between(a, b), edge_between(b, c), edge_between(c, a)};
    const double double_area = static_cast<double>(area) / (subpixels * subpixels);
    result.zinv = plane_of(corners, double_area, &Corner::zinv);
    if (lab.is_light_per_vertex || result.surface.is_bent)
        result.carried = plane_of(corners, double_area, &Corner::carried);
    return result;
}

Span span_of(int y, const ScreenTriangle& triangle) {
    std::int64_t begin = triangle.left, end = triangle.right;
    for (const Edge& edge : triangle.edges) {
        const std::int64_t inside = edge.start + edge.down * y; // at column 0
        if (edge.right > 0)
            begin = std::max(begin, floor_of(-inside, edge.right) + 1);
        else if (edge.right < 0)
            end = std::min(end, floor_of(inside - 1, -edge.right));
        else if (inside <= 0)
            return {};
    }
    if (begin > end) return {};
    return {static_cast<int>(begin), static_cast<int>(end)};
}

PixelLight pixel_light(const Lab& lab) {
    const float step = 1.0f / lab.focal_length;
    return {lab.light.position - lab.eye, (glm::vec2(0.5f) - middle_of(lab.picture.size)) * step,
            step};
}

} // namespace rasterwalk::rungs
