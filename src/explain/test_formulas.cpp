#include "explain/test_formulas.h"

#include <fmt/format.h>

#include "inspect/pixel_tests.h"

namespace rasterwalk {

namespace {

/// A coordinate of the grid in pixels.
Number in_pixels(std::int64_t coordinate) {
    return {static_cast<float>(coordinate) / static_cast<float>(grid_parts)};
}

Number in_square_pixels_shown(std::int64_t e) {
    return {static_cast<float>(in_square_pixels(e))};
}

std::string e_id(std::size_t i) {
    return fmt::format("e.{}", i);
}
std::string e_symbol(std::size_t i) {
    return fmt::format("E{}", i);
}

/// The two corners of an edge, in the order of its function.
struct EdgeEnds {
    std::string from, to;
};

EdgeEnds ends_of_edge(const TestedTriangle& triangle, std::size_t i,
                      const std::array<std::string, edge_function_count>& corners) {
    const std::size_t next = (i + 1) % edge_function_count;
    // If the corners go round counterclockwise each edge is reversed: then the next edge ends where
    // this one begins.
    const EdgeFunction &edge = triangle.edges[i], &other = triangle.edges[next];
    const GridPoint to{edge.from.x + edge.direction.dx, edge.from.y + edge.direction.dy};
    if (to == other.from) return {corners[i], corners[next]};
    return {corners[next], corners[i]};
}

Formula edge_formula(const TestedTriangle& triangle, const PixelTest& test, std::size_t i,
                     const std::array<std::string, edge_function_count>& corners,
                     PixelSample sample) {
    const EdgeFunction& edge = triangle.edges[i];
    const bool is_at_corner = sample == PixelSample::corner;
    const auto [from, to] = ends_of_edge(triangle, i, corners);
    const Source begin =
        from_words(from + (is_at_corner ? ", where the edge starts, half a pixel right and down"
                                        : ", where the edge starts"));
    const Source edge_source = from_words("the vector of the edge from " + from + " to " + to);
    const Source centre = from_words("the centre of the pixel, its number + 1/2");
    return {
        e_id(i),
        e_symbol(i),
        fmt::format("The edge function of {} at the pixel's centre, in square pixels, above 0 on "
                    "the inner side. It is also twice the area of the triangle that the edge and "
                    "the point form.{}",
                    tested_edge_name(edge.number),
                    is_at_corner ? " By mistake the pixel is tested at its upper left corner, as "
                                   "if the triangle were half a pixel too far right and down from "
                                   "its centre."
                                 : ""),
        "dx · (y − ay) − dy · (x − ax)",
        {{"dx", in_pixels(edge.direction.dx), edge_source},
         {"y", in_pixels(pixel_centre(test.row)), centre},
         {"ay", in_pixels(edge.from.y), begin},
         {"dy", in_pixels(edge.direction.dy), edge_source},
         {"x", in_pixels(pixel_centre(test.column)), centre},
         {"ax", in_pixels(edge.from.x), begin}},
        in_square_pixels_shown(test.e[i])};
}

} // namespace

std::size_t edge_of_weight(std::size_t corner, WeightEdge made_of) {
    // Edge 0 runs from corner 0 to 1 and lies opposite corner 2.
    return made_of == WeightEdge::own ? corner : (corner + 1) % edge_function_count;
}

std::vector<Formula> test_formulas(const TestedTriangle& triangle, const PixelTest& test,
                                   const std::array<std::string, edge_function_count>& corners,
                                   const Settings& settings) {
    const WeightEdge made_of = settings.weight_edge;
    std::vector<Formula> formulas;
    for (std::size_t i = 0; i < edge_function_count; ++i)
        formulas.push_back(edge_formula(triangle, test, i, corners, settings.pixel_sample));
    const auto e_input = [&](std::size_t i) {
        return FormulaInput{e_symbol(i), in_square_pixels_shown(test.e[i]), from_formula(e_id(i))};
    };
    formulas.push_back({"area",
                        "sum",
                        "The sum of the three edge functions. It is the same at every pixel, twice "
                        "the area of the triangle.",
                        "E0 + E1 + E2",
                        {e_input(0), e_input(1), e_input(2)},
                        in_square_pixels_shown(triangle.area)});
    if (triangle.area == 0) return formulas; // no corner has a weight
    for (std::size_t i = 0; i < edge_function_count; ++i) {
        const std::size_t edge = edge_of_weight(i, made_of);
        formulas.push_back(
            {fmt::format("weight.{}", i),
             "weight of " + corners[i],
             fmt::format(
                 "The weight of {} at this pixel: the edge function of {} as a fraction of the "
                 "sum.",
                 corners[i],
                 made_of == WeightEdge::own ? "the edge that starts at it (a mistake)"
                                            : "the opposite edge"),
             e_symbol(edge) + " / sum",
             {e_input(edge), {"sum", in_square_pixels_shown(triangle.area), from_formula("area")}},
             {test.weights[i]}});
    }
    return formulas;
}

} // namespace rasterwalk
