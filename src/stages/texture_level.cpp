#include "stages/texture_level.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "stages/fan.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

/// Where a corner is, for the pixels of its polygon, in pixels; the lab's walks go from whole pixel
/// to whole pixel.
glm::dvec2 standing_place(const ScreenVertex& vertex, const Stages& stages) {
    if (walks_edges(stages)) return {vertex.column, vertex.row};
    const GridPoint point = stages.snap(vertex);
    return glm::dvec2(static_cast<double>(point.x), static_cast<double>(point.y)) /
           static_cast<double>(grid_parts);
}

/// A triangle of the fan on the screen: two of its edges, and twice its area.
struct ScreenTriangle {
    const ScreenVertex* a;
    const ScreenVertex* b;
    const ScreenVertex* c;
    glm::dvec2 ab, ac;
    double area;
};

/// How much a value that is linear on the screen grows along x and along y.
template <class Value>
std::array<Value, 2> change_per_pixel(const ScreenTriangle& t, const Value& a, const Value& b,
                                      const Value& c) {
    return {((b - a) * t.ac.y - (c - a) * t.ab.y) / t.area,
            ((c - a) * t.ab.x - (b - a) * t.ac.x) / t.area};
}

} // namespace

TextureSlope texture_slope(PolygonCorners vertices, const Stages& stages) {
    ScreenTriangle largest{};
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        ScreenTriangle t{&vertices[0], &vertices[i - 1], &vertices[i], {}, {}, 0.0};
        const glm::dvec2 a = standing_place(*t.a, stages);
        t.ab = standing_place(*t.b, stages) - a;
        t.ac = standing_place(*t.c, stages) - a;
        t.area = t.ab.x * t.ac.y - t.ab.y * t.ac.x;
        if (std::abs(t.area) > std::abs(largest.area)) largest = t;
    }
    if (largest.a == nullptr) return {}; // no triangle has an area
    const auto weight = [&](const ScreenVertex* vertex) {
        return static_cast<double>(stages.recovery_weight(vertex->inv_w, stages));
    };
    const auto place = [](const ScreenVertex* vertex) {
        return glm::dvec2(vertex->varyings.texcoord);
    };
    const ScreenTriangle& t = largest;
    const auto places = change_per_pixel(t, place(t.a), place(t.b), place(t.c));
    const auto weights = change_per_pixel(t, weight(t.a), weight(t.b), weight(t.c));
    return {glm::vec2(places[0]), glm::vec2(places[1]), static_cast<float>(weights[0]),
            static_cast<float>(weights[1])};
}

TexturePlace texture_place(const glm::vec2& carried, float weight, const TextureSlope& slope) {
    const glm::vec2 texcoord = carried / weight;
    return {texcoord,
            {(slope.texcoord_right - texcoord * slope.weight_right) / weight,
             (slope.texcoord_down - texcoord * slope.weight_down) / weight}};
}

float side_in_texels(const glm::vec2& side, const TextureLevel& base) {
    const float x = side.x * static_cast<float>(base.width);
    const float y = side.y * static_cast<float>(base.height);
    return std::sqrt(x * x + y * y);
}

float log2_of(float number) {
    return static_cast<float>(std::log2(static_cast<double>(number)));
}

float texture_level(const Footprint& footprint, const Texture& texture) {
    const float right = side_in_texels(footprint.right, texture.base());
    const float down = side_in_texels(footprint.down, texture.base());
    // In this order NaN becomes 1.
    const float longer = std::max(1.0f, std::max(right, down));
    return std::min(log2_of(longer), static_cast<float>(texture.last_level()));
}

} // namespace rasterwalk
