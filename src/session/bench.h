#pragma once

#include <glm/vec2.hpp>

#include "session/session.h"

namespace rasterwalk {

/// True for a scene in pixel space, whose vertices can be moved on the grid.
bool is_bench(const Scene& scene);

/// Puts a vertex of a bench triangle on a pixel. Does nothing in any other scene.
void move_bench_vertex(Session& session, int triangle, int vertex, glm::ivec2 pixel);

/// Puts one of the scene's examples in place of its first triangle, and goes to the end.
void show_bench_example(Session& session, const BenchExample& example);

} // namespace rasterwalk
