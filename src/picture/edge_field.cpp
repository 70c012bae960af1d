#include "picture/edge_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterwalk {

namespace {

/// E as a function of a place in the picture, pixels: a + b . place, square pixels.
struct LinearField {
    double a = 0.0;
    glm::dvec2 b{0.0};

    double at(const glm::dvec2& p) const { return a + b.x * p.x + b.y * p.y; }
};

LinearField linear_field(const EdgeField& field) {
    const EdgeFunction& e = field.edge;
    constexpr double parts = grid_parts;
    return {in_square_pixels(e.at({0, 0})),
            {static_cast<double>(-e.direction.dy) / parts,
             static_cast<double>(e.direction.dx) / parts}};
}

/// Where E has a value on the border of a rectangle, at most two places.
std::vector<glm::dvec2> on_border(const LinearField& field, double e, glm::dvec2 low,
                                  glm::dvec2 high) {
    const std::array<glm::dvec2, 4> corners{low, glm::dvec2(high.x, low.y), high,
                                            glm::dvec2(low.x, high.y)};
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const double at_p = field.at(p) - e, at_q = field.at(q) - e;
        // A corner belongs to the side that begins there.
        if (at_p == 0.0 || (at_p < 0.0) != (at_q < 0.0)) {
            if (at_p != 0.0 && at_q == 0.0) continue;
            const double share = at_p == 0.0 ? 0.0 : at_p / (at_p - at_q);
            places.push_back(p + share * (q - p));
        }
    }
    return places;
}

} // namespace

std::optional<EdgeField> edge_field(const Frame& frame, int triangle, int edge) {
    const PolygonCorners vertices = frame.triangle_vertices(triangle);
    const int last = static_cast<int>(vertices.size()) - 1;
    TestedPolygon polygon;
    set_up_tests(vertices, frame.stages, polygon);
    const int number = std::clamp(edge, 0, last);
    const EdgeFunction* function = nullptr;
    for (const TestedTriangle& of : polygon.triangles) {
        for (const EdgeFunction& e : of.edges) {
            if (of.area > 0 && e.number == number) function = &e;
        }
    }
    if (function == nullptr) return std::nullopt;
    EdgeField field{triangle, *function};
    // E changes evenly, so it is largest in a corner.
    const Viewport size = frame.settings.viewport;
    for (const int column : {0, size.width - 1}) {
        for (const int row : {0, size.height - 1})
            field.largest = std::max(field.largest, std::abs(field.at(column, row)));
    }
    return field;
}

std::vector<FieldLine> field_lines(const EdgeField& field, glm::dvec2 low, glm::dvec2 high,
                                   double step) {
    std::vector<FieldLine> lines;
    if (!(step > 0.0) || !(low.x < high.x) || !(low.y < high.y)) return lines;
    const LinearField e = linear_field(field);
    const std::array<double, 4> corners{e.at(low), e.at({high.x, low.y}), e.at(high),
                                        e.at({low.x, high.y})};
    const auto [least, most] = std::minmax_element(corners.begin(), corners.end());
    for (double n = std::ceil(*least / step);
         n <= std::floor(*most / step) && lines.size() < most_field_lines; n += 1.0) {
        const std::vector<glm::dvec2> ends = on_border(e, n * step, low, high);
        if (ends.size() == 2) lines.push_back({n * step, ends[0], ends[1]});
    }
    return lines;
}

double field_step(const EdgeField& field, double least_distance) {
    const glm::dvec2 slope = linear_field(field).b;
    const double length = std::hypot(slope.x, slope.y);
    if (!(length > 0.0)) return 0.0;
    double step = 1.0;
    for (int i = 0; step < least_distance * length; ++i)
        step *= i % 3 == 1 ? 2.5 : 2.0;
    return step;
}

} // namespace rasterwalk
