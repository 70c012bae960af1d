#include "picture/weight_parts.h"

namespace rasterwalk {

std::optional<WeightParts> weight_parts(const Frame& frame, int triangle, glm::ivec2 pixel) {
    const PolygonCorners vertices = frame.triangle_vertices(triangle);
    if (vertices.size() < edge_function_count) return std::nullopt;
    TestedPolygon polygon;
    set_up_tests(vertices, frame.stages, polygon);
    const TestedTriangle& of = triangle_of_pixel(polygon, pixel.x, pixel.y);
    if (of.area == 0) return std::nullopt;
    WeightParts result{triangle, pixel, {pixel_centre(pixel.x), pixel_centre(pixel.y)}, {}};
    const Weights weights = frame.stages.weights(of.values_at(result.centre), of.area);
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const EdgeFunction& edge = of.edges[i];
        const std::size_t opposite = (i + 2) % result.parts.size();
        result.parts[i] = {edge.from,
                           {edge.from.x + edge.direction.dx, edge.from.y + edge.direction.dy},
                           edge.number,
                           of.corners[opposite],
                           weights[opposite]};
    }
    return result;
}

} // namespace rasterwalk
