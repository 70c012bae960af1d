#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "session/session.h"

namespace rasterwalk {

/// True for a scene in pixel space, whose vertices can be moved on the grid.
bool is_bench(const Scene& scene);

/// Puts a vertex of a bench triangle on a pixel. Does nothing in other scenes.
void move_bench_vertex(Session& session, int triangle, int vertex, glm::ivec2 pixel);

/// Where the vertices of a bench triangle are: column, row, depth.
struct PlacedTriangle {
    int triangle = 0;
    std::array<glm::vec3, 3> positions;

    friend bool operator==(const PlacedTriangle&, const PlacedTriangle&) = default;
};

/// As text: "10,5/5,10/15,15", with a depth other than 1 after its row ("10,5,2"), and a triangle
/// other than the first in front ("3:10,5/5,10/15,15"). Reading throws UsageError.
std::string to_text(const PlacedTriangle& placed);
PlacedTriangle parse_placed_triangle(std::string_view text);

/// Moves the vertices of a bench triangle. Throws UsageError for a scene or a triangle that cannot
/// be moved.
void place_triangle(Session& session, const PlacedTriangle& placed);

/// The triangles of a bench scene whose vertices differ from those in `original`, the scene as its
/// file has it; none in other scenes.
std::vector<PlacedTriangle> moved_triangles(const Scene& scene, const Scene& original);

/// Puts one of the scene's examples in place of its first triangle, and goes to the end.
void show_bench_example(Session& session, const BenchExample& example);

/// The most triangles that a lesson or a saved view may move.
inline constexpr std::size_t most_placed_triangles = 1000;

} // namespace rasterwalk
